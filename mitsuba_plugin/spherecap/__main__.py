"""Prints where `FindMitsubaWheel.cmake` is, for CMake: `python -m spherecap --cmake_dir`."""

import argparse
from pathlib import Path


def main() -> None:
    """Print what was asked for."""
    parser = argparse.ArgumentParser(prog="python -m spherecap")
    parser.add_argument(
        "--cmake_dir", action="store_true", required=True, help="print the folder of FindMitsubaWheel.cmake"
    )
    parser.parse_args()
    print(Path(__file__).resolve().parent / "cmake")


if __name__ == "__main__":
    main()

"""Build the report: `make report`."""

import sys

from renderlab.scenes import OUTPUT, REPOSITORY
from spherecap_command.errors import UserError

from report.build import build, full_plan

if __name__ == "__main__":
    try:
        print(f"report: {build(OUTPUT, REPOSITORY / 'report', full_plan())}")
    except UserError as error:
        sys.exit(f"report: {error}")

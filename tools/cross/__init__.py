"""One set of scenes for several renderers, and the comparison of what they make of it (`make cross`).

`scene.py` describes the scenes, a `render_*.py` turns them into one renderer's input and runs it, in that
renderer's own Python environment. So these files, and what they import from here, need numpy alone.
"""

"""The one kind of error that the command reports in a sentence instead of a traceback."""


class UserError(Exception):
    """Something the user can put right; the message says how."""

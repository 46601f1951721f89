"""The one kind of error that a user is meant to see, and the exit statuses of sundrape's commands."""

BAD_USE = 2
FILE_TROUBLE = 3
INTERRUPTED = 130


class PostprocError(Exception):
    """Something the user can put right: the message is one line, `status` is what the command exits with."""

    def __init__(self, message: str, status: int = FILE_TROUBLE) -> None:
        super().__init__(message)
        self.status = status

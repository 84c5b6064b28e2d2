"""A design for `check`, and the truth of one of its checks."""


class Case:
    """The words of a command line, and whether the condition of `check` holds there. A case is not
    `confirmed` where a second computation of the truth gave something else."""

    def __init__(self, check):
        self.check, self.holds, self.confirmed, self.words = check, True, True, []

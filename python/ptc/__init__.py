"""The former name of `ptc_codegen`, for one version.

PyPI has another package called ``ptc``: write ``import ptc_codegen as ptc``.
"""

import warnings

from ptc_codegen import *
from ptc_codegen import __all__  # noqa: F401

warnings.warn(
    "the module `ptc` is called `ptc_codegen`; write `import ptc_codegen as ptc`",
    DeprecationWarning,
    stacklevel=2,
)

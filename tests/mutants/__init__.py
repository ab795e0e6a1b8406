"""Mutation testing: small wrong changes to the numerics, each of which some test must notice.

``generate`` makes the mutants, ``concern`` finds out which tests run which lines, ``run`` tries mutants, ``__main__``
is the command that ``make mutants`` calls. A tool for developers: no part of the package, and no test.
"""

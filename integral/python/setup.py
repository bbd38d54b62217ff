# SPDX-License-Identifier: AGPL-3.0-or-later
"""Marks the wheel as one for this machine and this Python: its module is compiled already."""
from setuptools import Distribution, setup


class CompiledDistribution(Distribution):
    def has_ext_modules(self):
        return True


setup(distclass=CompiledDistribution)

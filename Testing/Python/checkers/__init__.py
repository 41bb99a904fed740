# SPDX-License-Identifier: BSD-3-Clause
"""Strict readers of the formats of solvers, each written from the format's manual: read(path) gives a Model or raises Bad."""

# SPDX-License-Identifier: AGPL-3.0-or-later
# Measurements: built on request (make bench), never asserted.

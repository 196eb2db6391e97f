# SPDX-License-Identifier: Apache-2.0
"""What the tools and the tests share: running programs under limits and comparing images."""

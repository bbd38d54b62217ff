// SPDX-License-Identifier: AGPL-3.0-or-later
// The unit tests' program; every other file of this folder adds its own BOOST_AUTO_TEST_SUITE.
#define BOOST_TEST_MODULE unit
#include <boost/test/unit_test.hpp>

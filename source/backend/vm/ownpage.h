// SPDX-License-Identifier: AGPL-3.0-or-later
// Places a function at the start of a page of memory. The processor's branch prediction depends on
// the lower bits of addresses: an interpreter's speed then does not depend on what the linker puts
// before it.
#ifndef POVRAY_BACKEND_OWNPAGE_H
#define POVRAY_BACKEND_OWNPAGE_H

#define POV_AT_START_OF_PAGE __attribute__((aligned(4096)))

#endif

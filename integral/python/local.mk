# SPDX-License-Identifier: AGPL-3.0-or-later
# The Python package integral: one line per file, headers too. `make python` builds it in
# build/python, ready to be imported from there.

python_module_sources = \
  integral/python/arrays.cpp \
  integral/python/arrays.h \
  integral/python/bind_compare.cpp \
  integral/python/bind_depth.cpp \
  integral/python/bind_frame.cpp \
  integral/python/bind_io.cpp \
  integral/python/bind_optics.cpp \
  integral/python/bind_panel.cpp \
  integral/python/bind_replay.cpp \
  integral/python/bind_sheet.cpp \
  integral/python/bind_views.cpp \
  integral/python/calls.cpp \
  integral/python/calls.h \
  integral/python/module.cpp \
  integral/python/rooms.h

python_package_files = \
  integral/python/integral/__init__.py \
  integral/python/integral/_integral.pyi \
  integral/python/integral/camera.py \
  integral/python/integral/frame.py \
  integral/python/integral/geometry.py \
  integral/python/integral/light_field.py \
  integral/python/integral/measuring.py \
  integral/python/integral/py.typed \
  integral/python/integral/quilt.py \
  integral/python/integral/viewing.py

EXTRA_DIST += $(python_module_sources) $(python_package_files) integral/python/pyproject.toml \
  integral/python/setup.py

if HAVE_PYTHON
EXTRA_PROGRAMS += build/python/integral/_integral.so
build_python_integral__integral_so_SOURCES = $(python_module_sources)
build_python_integral__integral_so_CPPFLAGS = $(AM_CPPFLAGS) $(PYTHON_CPPFLAGS)
build_python_integral__integral_so_CXXFLAGS = $(AM_CXXFLAGS) -fvisibility=hidden
build_python_integral__integral_so_LDADD = $(LIBINTEGRAL_LIBS)
build_python_integral__integral_so_LINK = $(CXXLD) $(AM_CXXFLAGS) $(CXXFLAGS) -shared -Wl,--exclude-libs,ALL \
  -Wl,--as-needed $(LDFLAGS) -o $@

# What takes time is in libintegral, so that the bindings, templates of pybind11's for the most part,
# need less optimizing, which takes a quarter of their time to compile.
$(build_python_integral__integral_so_OBJECTS): CXXFLAGS += -O1

python_package = $(python_package_files:integral/python/%=build/python/%)
$(python_package): build/python/%: integral/python/%
	$(AM_V_GEN)$(MKDIR_P) $(@D) && cp $< $@
CLEANFILES += $(python_package)

python: build/python/integral/_integral.so $(python_package)
python_tests = python

# A wheel for this machine in build/python, by setuptools: `pip install` takes it.
python-wheel: python
	cp $(srcdir)/integral/python/setup.py build/python
	sed 's/%version%/$(PACKAGE_VERSION)/' $(srcdir)/integral/python/pyproject.toml > build/python/pyproject.toml
	cd build/python && $(PYTHON) -m pip wheel --quiet --no-deps --no-build-isolation .

install-python: python
	$(MKDIR_P) '$(DESTDIR)$(pythondir)/integral'
	$(INSTALL_DATA) $(python_package) build/python/integral/_integral.so '$(DESTDIR)$(pythondir)/integral'

uninstall-python:
	rm -rf '$(DESTDIR)$(pythondir)/integral'
else
python python-wheel install-python:
	@echo "the Python module cannot be built; $(PYTHON_ADVICE)" >&2; exit 1
uninstall-python:
endif
.PHONY: python python-wheel install-python uninstall-python

# What `make`, `make install` and `make uninstall` do (unix/local.mk).
if WITH_PYTHON
python_of_all = python
python_of_install = install-python
python_of_uninstall = uninstall-python
endif

# What each target of the Makefile needs, by the names of packages, and how they are installed: with apt-get on Debian 12
# and Ubuntu 24.04, whose names are the same, or with dnf on Fedora. Other systems are told Debian's names.
SUDO := $(shell [ "$$(id -u)" = 0 ] || echo sudo)
SYSTEM := $(shell . /etc/os-release 2>/dev/null && echo $$ID)
INSTALLER := $(firstword $(foreach tool,apt-get dnf,$(if $(shell command -v $(tool)),$(tool))))

ifeq ($(INSTALLER),dnf)
BUILD_PACKAGES := gcc-c++ cmake ninja-build ccache eigen3-devel tbb-devel Random123-devel boost-devel tomlplusplus-devel \
  json-devel cli11-devel fmt-devel xxhash-devel gdal-devel proj-devel sqlite-devel openmpi-devel cpp-httplib-devel \
  qhull-devel openssl-devel python3-devel python3-numpy pybind11-devel
NPM_PACKAGES := nodejs nodejs-npm
TEST_PACKAGES := gtest-devel gmock-devel gdal clang python3 chromium poppler-utils python3-pytest python3-pandas \
  python3-matplotlib python3-xarray python3-nbclient python3-ipykernel python3-rasterio python3-geopandas valgrind
QGIS_PACKAGES := qgis python3-qgis xorg-x11-server-Xvfb xauth
DOCS_PACKAGES := python3-sphinx python3-myst-parser python3-furo
FUZZ_PACKAGES := clang compiler-rt
# Where CMake finds Fedora's MPI without `module load`.
export PATH := $(PATH):/usr/lib64/openmpi/bin
else
BUILD_PACKAGES := g++ cmake ninja-build ccache libeigen3-dev libtbb-dev librandom123-dev libboost-dev \
  libtomlplusplus-dev nlohmann-json3-dev libcli11-dev libfmt-dev libxxhash-dev libgdal-dev libproj-dev libsqlite3-dev \
  libopenmpi-dev libcpp-httplib-dev libqhull-dev libssl-dev python3-dev python3-numpy pybind11-dev
NPM_PACKAGES := nodejs npm
TEST_PACKAGES := libgtest-dev libgmock-dev openmpi-bin gdal-bin clang-14 python3 poppler-utils esbuild node-d3 \
  python3-pytest python3-pandas python3-matplotlib python3-xarray python3-nbclient python3-ipykernel python3-rasterio \
  python3-geopandas valgrind
# Ubuntu has Chromium as a snap only: snap install chromium.
ifneq ($(SYSTEM),ubuntu)
TEST_PACKAGES += chromium
endif
QGIS_PACKAGES := qgis python3-qgis qgis-providers xvfb xauth
DOCS_PACKAGES := python3-sphinx python3-myst-parser furo node-normalize.css
FUZZ_PACKAGES := clang-14 libclang-rt-14-dev
endif
# For packages of Debian, on Debian.
PACK_PACKAGES := dpkg-dev lintian desktop-file-utils

# Node.js may be there from elsewhere, and the distribution's npm would not go with it.
NODE_PACKAGES := $(shell command -v npm >/dev/null || echo $(NPM_PACKAGES))

apt-get.has := dpkg-query -W -f='$${Status}' $$p 2>/dev/null | grep -q 'ok installed'
apt-get.install := $(SUDO) apt-get update -q >/dev/null && \
  DEBIAN_FRONTEND=noninteractive $(SUDO) apt-get install -y -q --no-install-recommends
dnf.has := rpm -q --whatprovides $$p >/dev/null 2>&1
dnf.install := $(SUDO) dnf install -y -q --setopt=install_weak_deps=False

# $(call install,PACKAGES): those that are missing.
ifneq ($(INSTALLER),)
define install
	@missing=""; for p in $(1); do $($(INSTALLER).has) || missing="$$missing $$p"; done; \
	if [ -n "$$missing" ]; then echo "installing$$missing"; $($(INSTALLER).install) $$missing >/dev/null; fi
endef
else
define install
	@echo "This system has neither apt-get nor dnf. Needed are what Debian calls: $(1)"
endef
endif

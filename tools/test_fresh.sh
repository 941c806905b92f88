#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# test_fresh.sh [TARGET...]: on a bare Debian 12 in build/fresh, with nothing added but make and
# git, clones the last commit and runs `make demo` and `make test` (or the targets named); then
# `make demo` once more as a user who is not root and has no network.
source "$(dirname "$0")/lib.sh"

system=$PWD/build/fresh/system
clone=/srv/percolith
targets=("${@:-demo}")
if (($# == 0)); then
  targets=(demo test)
fi

if ((EUID != 0)); then
  echo "error: make test-fresh makes a system in build/fresh and must be root to do so; run:" >&2
  echo "  sudo make test-fresh" >&2
  exit 1
fi

# The mirror and the proxy are those of the machine's own apt.
# shellcheck disable=SC2016  # apt expands the format itself
mirror=$(apt-get indextargets --format '$(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' |
  awk '$2 == "bookworm" && $3 == "main" { print $1; exit }')
if [[ -z $mirror ]]; then
  echo "error: the machine's apt knows no repository of bookworm main to install from" >&2
  exit 1
fi
proxy=$(apt-config dump --format '%v' Acquire::http::Proxy)
if [[ -n $proxy ]]; then
  export http_proxy=${http_proxy:-$proxy}
fi

carried_environment() {
  local name
  for name in $(compgen -e); do
    case $name in
      PIP_* | http_proxy | https_proxy | no_proxy | HTTP_PROXY | HTTPS_PROXY | NO_PROXY | \
        SSL_CERT_FILE | REQUESTS_CA_BUNDLE)
        printf '%s=%s\0' "$name" "${!name}"
        ;;
    esac
  done
}

carry_configuration() {
  local path
  for path in /etc/apt/sources.list /etc/apt/sources.list.d /etc/apt/apt.conf.d \
    /etc/apt/preferences.d /etc/apt/auth.conf.d /etc/apt/trusted.gpg.d /etc/apt/keyrings \
    /etc/pip.conf /usr/local/share/ca-certificates /etc/ssl/certs/ca-certificates.crt; do
    rm -rf "${system:?}$path"
    if [[ -e $path ]]; then
      mkdir -p "$system$(dirname "$path")"
      cp -aL "$path" "$system$path"
    fi
  done
  cp -L /etc/resolv.conf /etc/hosts "$system/etc/"
}

# inside COMMAND...: runs it in the new system; its mounts vanish with the namespace.
inside() {
  local environment
  mapfile -d '' environment < <(carried_environment)
  # shellcheck disable=SC2016  # the inner shell expands its own arguments
  unshare --mount --propagation private ${isolation:+"$isolation"} bash -c '
    system=$1 && shift
    mount -t proc proc "$system/proc"
    mount --rbind /dev "$system/dev"
    exec chroot "$system" /usr/bin/env -i "$@"' inside "$system" \
    PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 HOME=/srv "${environment[@]}" "$@"
}

tools/setup.sh fresh
say "a bare Debian 12"
rm -rf build/fresh
mkdir -p build/fresh
debootstrap --variant=minbase bookworm "$system" "$mirror" >build/fresh/debootstrap.log 2>&1 || {
  tail -n 20 build/fresh/debootstrap.log >&2
  exit 1
}
carry_configuration
inside bash -c 'apt-get -q update && apt-get -q -y install make git' >build/fresh/apt.log 2>&1 || {
  tail -n 20 build/fresh/apt.log >&2
  exit 1
}
git clone -q --no-local . "$system$clone"

for target in "${targets[@]}"; do
  say "make $target, first run"
  SECONDS=0
  inside make -C "$clone" "$target"
  echo "make $target took $SECONDS s"
done

say "make ${targets[0]}, second run: not root, no network"
inside useradd --create-home newcomer
inside chown -R newcomer "$clone"
SECONDS=0
isolation=--net inside su - newcomer -c "make -C $clone ${targets[0]}"
echo "make ${targets[0]} took $SECONDS s"
say "passed on a bare Debian 12: ${targets[*]}"

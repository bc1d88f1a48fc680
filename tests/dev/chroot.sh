# Functions for a bare Debian 12 in a chroot: debootstrap's minbase. Packages of the host are invisible
# there. For sourcing; the caller defines fail(), which prints a message and exits.
#
# The chroot gets only the files and settings needed to reach Debian and npm: Debian's apt sources, keys,
# certificates, proxy and registry settings.
# shellcheck shell=bash

release=bookworm

# Prints the host's apt sources for the release, in the format of sources.list.
# shellcheck disable=SC2016 # apt expands these
debian_sources() {
  apt-get indextargets --format '$(ORIGIN)|$(REPO_URI)|$(RELEASE)|$(COMPONENT)' 'Created-By: Packages' |
    awk -F '|' -v release="$release" \
      '$1 == "Debian" && index($3, release) == 1 { print "deb", $2, $3, $4 }' | sort -u
}

# copy_to ROOT PATH...: copies existing paths to the same location in the chroot, following links.
copy_to() {
  local root=$1 path paths=()
  shift
  for path; do [[ ! -e $path ]] || paths+=("${path#/}"); done
  ((${#paths[@]} == 0)) || tar -C / -chf - "${paths[@]}" | tar -C "$root" -xf -
}

# Prints the environment variables needed to reach servers as NAME=VALUE: proxies, certificates, npm.
# grep fails if there are none, as on most machines.
network_environment() {
  local npm='npm_config_([a-z_]*registry|[a-z_]*proxy|cafile)'
  env | grep -iE "^((https?|ftp|all|no)_proxy|ssl_cert_(file|dir)|node_extra_ca_certs|$npm)=" || true
}

# make_chroot FOLDER [PACKAGE...]: makes FOLDER/root, with these packages and ca-certificates. Nothing may be
# in FOLDER that is still needed.
make_chroot() {
  local folder=$1 root=$1/root mirror variable path packages
  shift
  packages=$(IFS=, && echo "ca-certificates${*:+,$*}")
  # Nothing is mounted there anymore, because mounts end with the command that made them.
  rm -rf --one-file-system "$folder" && mkdir -p "$folder"
  debian_sources >"$folder/sources.list"
  mirror=$(awk -v release="$release" '$3 == release && $4 == "main" { print $2; exit }' \
    "$folder/sources.list")
  [[ $mirror ]] || fail "apt has no source for Debian $release here; try apt-get update"
  debootstrap --variant=minbase --include="$packages" "$release" "$root" "$mirror" \
    >"$folder/debootstrap.log" 2>&1 || fail "debootstrap failed: see $folder/debootstrap.log"
  cp "$folder/sources.list" "$root/etc/apt/sources.list"
  apt-config dump | grep '^Acquire::' >"$root/etc/apt/apt.conf.d/90-acquire"
  copy_to "$root" /etc/apt/auth.conf /etc/apt/auth.conf.d /etc/apt/keyrings /etc/apt/trusted.gpg \
    /etc/apt/trusted.gpg.d /etc/ssl/certs /usr/local/share/ca-certificates /etc/resolv.conf /etc/npmrc \
    "$HOME/.npmrc"
  while IFS='=' read -r variable path; do
    [[ $path != /* || $variable == *[Pp][Rr][Oo][Xx][Yy] ]] || copy_to "$root" "$path"
  done < <(network_environment)
}

# inside FOLDER COMMAND: runs a shell command in FOLDER/root. Mounts and processes end with it. There is
# deliberately no /sys and no /etc/hosts, so that the system is minimal.
inside() {
  local environment
  mapfile -t environment < <(network_environment)
  # shellcheck disable=SC2016 # expanded by the inner shell
  unshare --mount --pid --fork --kill-child bash -c '
    root=$1 && shift
    mount -t proc proc "$root/proc"
    mount -t devpts devpts "$root/dev/pts" -o newinstance,ptmxmode=0666
    mount -t tmpfs tmpfs "$root/dev/shm"
    ln -sf pts/ptmx "$root/dev/ptmx"
    exec chroot "$root" env -i "$@"' \
    bash "$1/root" HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin TERM=dumb "${environment[@]}" \
    bash -c "$2" </dev/null
}

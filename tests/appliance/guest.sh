#!/bin/sh
# What makes a minimal Debian the rig's guest. mmdebstrap runs it outside, as root of the guest's files:
#   guest.sh early ROOT             before the kernel is unpacked
#   guest.sh late ROOT DIRECTORY    at the end; writes kernel, initrd and base.raw into DIRECTORY
set -eu
step=$1 root=$2

early() {
    # Only what the virtual machine's disk needs: 6 MB instead of 30, and 10 s less of an emulated boot.
    mkdir -p "$root/etc/initramfs-tools/conf.d"
    printf 'MODULES=list\nCOMPRESS=zstd\nBUSYBOX=n\n' >"$root/etc/initramfs-tools/conf.d/rig"
    printf 'virtio_pci\nvirtio_blk\next4\ncrc32c_generic\n' >"$root/etc/initramfs-tools/modules"
}

late() {
    out=$3
    echo vitrine >"$root/etc/hostname"
    printf '/dev/vda / ext4 rw,noatime,errors=remount-ro 0 1\n' >"$root/etc/fstab"
    sed -i 's/^root:[^:]*:/root::/' "$root/etc/shadow"
    mkdir -p "$root/host" "$root/etc/systemd/journald.conf.d"
    printf '[Journal]\nStorage=volatile\nRateLimitIntervalSec=0\n' >"$root/etc/systemd/journald.conf.d/rig.conf"
    for unit in apt-daily.timer apt-daily-upgrade.timer dpkg-db-backup.timer e2scrub_all.timer e2scrub_reap.service \
        fstrim.timer systemd-timesyncd.service systemd-pstore.service; do
        chroot "$root" systemctl mask -q "$unit"
    done
    initrd=$(echo "$root"/boot/initrd.img-*)
    zstd -q -d -f -o "$out/initrd" "$initrd" 2>/dev/null || cp "$initrd" "$out/initrd"
    cp "$root"/boot/vmlinuz-* "$out/vmlinuz"
    basename "$root"/boot/vmlinuz-* | sed 's/^vmlinuz-//' >"$out/kernel-release"
    # mmdebstrap's, which keep packages from starting services, and it would take them away only later.
    rm -f "$root/usr/sbin/policy-rc.d"
    [ ! -e "$root/sbin/start-stop-daemon.REAL" ] || mv "$root/sbin/start-stop-daemon.REAL" "$root/sbin/start-stop-daemon"
    rm -rf "${root:?}"/boot/* "$root"/var/cache/apt/* "$root"/var/lib/apt/lists/*
    # mmdebstrap has /proc and /sys mounted in it; a second view of the tree is without them.
    tree=$(mktemp -d)
    mount --bind "$root" "$tree"
    mke2fs -q -t ext4 -E lazy_itable_init=0 -d "$tree" -r 1 -m 0 -L root "$out/base.raw" 3G
    umount "$tree"
    rmdir "$tree"
}

"$step" "$@"

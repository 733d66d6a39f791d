#!/bin/sh
# What makes a minimal Debian the appliance. mmdebstrap runs it outside, as root of the appliance's files:
#   guest.sh early ROOT                     before the packages are unpacked
#   guest.sh late ROOT HERE PACKAGES OUT    at the end: HERE has root/, PACKAGES Vitrine's own; OUT takes root.ext4, EFI/ and grub/
set -eu
step=$1 root=$2

early() {
    mkdir -p "$root/etc/initramfs-tools/conf.d"
    printf 'MODULES=most\nCOMPRESS=zstd\nBUSYBOX=n\n' >"$root/etc/initramfs-tools/conf.d/appliance"
}

inside() { chroot "$root" env DEBIAN_FRONTEND=noninteractive "$@"; }

# GRUB for firmware of both kinds; the one for UEFI is Debian's signed one, so that Secure Boot may stay on.
loaders() {
    mkdir -p "$out/EFI/BOOT" "$out/EFI/debian" "$out/grub"
    cp "$root/usr/lib/shim/shimx64.efi.signed" "$out/EFI/BOOT/BOOTX64.EFI"
    cp "$root/usr/lib/grub/x86_64-efi-signed/grubx64.efi.signed" "$out/EFI/BOOT/grubx64.efi"
    inside grub-mkimage -O i386-pc -o /tmp/core.img -p '(,gpt2)/EFI/debian' biosdisk part_gpt fat ext2 normal linux \
        configfile search search_label echo test sleep minicmd
    cp "$root/usr/lib/grub/i386-pc/boot.img" "$root/tmp/core.img" "$out/grub"
    inside apt-get -q -y --allow-remove-essential purge --autoremove grub-pc-bin grub-efi-amd64-signed shim-signed
}

settle() {
    chmod -R u=rwX,go=rX "$here/root"
    cp -a --no-preserve=ownership "$here/root/." "$root"
    chmod +x "$root"/usr/lib/vitrine-appliance/*
    cp "$root/usr/share/doc/vitrine/examples/smb.conf" "$root/etc/samba/smb.conf"
    echo 'include = /run/vitrine-appliance/share-open.conf' >>"$root/etc/samba/smb.conf"
    echo vitrine >"$root/etc/hostname"
    ln -sfn /etc/vitrine/localtime "$root/etc/localtime"
    # The machine's id is found anew at each start; without the file systemd would take each start for the first.
    : >"$root/etc/machine-id"
    mkdir -p "$root/data" "$root/var/lib/vitrine" "$root/var/cache/vitrine" "$root/var/cache/samba"
    inside passwd -q -l root
    inside systemctl -q enable systemd-networkd systemd-timesyncd smbd avahi-daemon wsdd vitrine-setup vitrine.target
    inside systemctl -q mask getty@tty1.service nmbd.service samba-ad-dc.service apt-daily.timer apt-daily-upgrade.timer \
        dpkg-db-backup.timer e2scrub_all.timer e2scrub_reap.service systemd-machine-id-commit.service \
        systemd-networkd-wait-online.service systemd-pstore.service
    # mmdebstrap's, which keep packages from starting services, and it would take them away only later.
    rm -f "$root/usr/sbin/policy-rc.d"
    [ ! -e "$root/sbin/start-stop-daemon.REAL" ] || mv "$root/sbin/start-stop-daemon.REAL" "$root/sbin/start-stop-daemon"
    rm -rf "$root"/var/cache/apt/* "$root"/var/lib/apt/lists/* "$root"/tmp/* "$root"/var/log/* "$root/etc/resolv.conf"
}

late() {
    here=$3 packages=$4 out=$5
    for name in vitrine vitrine-analyzer vitrine-player; do cp "$packages/$name"_*.deb "$root/tmp"; done
    (cd "$root" && for file in tmp/vitrine*.deb; do echo "/$file"; done) | xargs chroot "$root" \
        env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o APT::Install-Recommends=false install
    loaders
    # Once, and not with each package that asks for it (INITRD=No).
    inside update-initramfs -c -k all
    ln -sfn "$(cd "$root" && echo boot/initrd.img-*)" "$root/initrd.img"
    settle
    # mmdebstrap has /proc and /sys mounted in it; a second view of the tree is without them.
    tree=$(mktemp -d)
    mount --bind "$root" "$tree"
    used=$(du -s -m "$tree" | cut -f1)
    mke2fs -q -t ext4 -E lazy_itable_init=0 -d "$tree" -r 1 -m 0 -L vitrine-root "$out/root.ext4" "$((used * 115 / 100 + 256))M"
    umount "$tree"
    rmdir "$tree"
}

"$step" "$@"

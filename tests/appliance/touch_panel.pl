#!/usr/bin/perl
# A touch panel of ten contacts in the rig's guest, as uinput makes it; the guest has Perl, and no Python.
#
#   touch_panel.pl WIDTH HEIGHT FIFO
#
# Reads lines from FIFO: "SLOT X Y" puts a contact down or moves it, "SLOT up" lifts it, "rest SECONDS" waits.
use strict;
use warnings;

my ($width, $height, $fifo) = @ARGV;

# linux/uinput.h and linux/input-event-codes.h
my ($set_type, $set_key, $set_axis, $set_property, $create) = (0x40045564, 0x40045565, 0x40045567, 0x4004556e, 0x5501);
my ($syn, $key, $abs) = (0, 1, 3);
my ($x, $y, $slot, $mt_x, $mt_y, $tracking, $btn_touch, $direct) = (0x00, 0x01, 0x2f, 0x35, 0x36, 0x39, 0x14a, 1);
my %highest = ($x => $width - 1, $y => $height - 1, $mt_x => $width - 1, $mt_y => $height - 1, $slot => 9, $tracking => 65535);

open my $panel, '+<', '/dev/uinput' or die "uinput: $!";
sub control { my ($what, $value) = @_; defined ioctl $panel, $what, 0 + $value or die "ioctl: $!" }

control($set_type, $_) for $key, $abs;
control($set_key, $btn_touch);
control($set_axis, $_) for sort keys %highest;
control($set_property, $direct);
my @most = map { $highest{$_} // 0 } 0 .. 63;
syswrite $panel, pack 'a80 S4 L l64 l192', 'rig panel', 3, 1, 1, 1, 0, @most, (0) x 192 or die "write: $!";
control($create, 0);

sub tell_panel { syswrite $panel, pack('q2 S2 l', 0, 0, splice @_, 0, 3) or die "write: $!" while @_ }

$| = 1;
my (%down, $contacts);
while (1) {
    open my $lines, '<', $fifo or die "$fifo: $!";
    while (<$lines>) {
        my ($which, @at) = split;
        if ($which eq 'rest') { select undef, undef, undef, $at[0]; next }
        my @events = ($abs, $slot, $which);
        if ($at[0] eq 'up') {
            delete $down{$which};
            push @events, $abs, $tracking, -1;
            push @events, $key, $btn_touch, 0 if !%down;
        } else {
            push @events, $abs, $tracking, ++$contacts % 65536 if !$down{$which};
            push @events, $key, $btn_touch, 1 if !%down;
            push @events, $abs, $mt_x, int $at[0], $abs, $mt_y, int $at[1];
            $down{$which} = 1;
        }
        tell_panel(@events, $syn, 0, 0);
    }
}

"""What the networks are shown: random parts of pictures, other subjects laid over them, other light."""

import torch
import torch.nn.functional as functional

FULL = 320  # px, of the teacher's look


def chance(count, share, device):
    """A random choice of that share, as N x 1 x 1 x 1 of 0 and 1."""
    return (torch.rand(count, 1, 1, 1, device=device) < share).float()


def uniform(count, low, high, device):
    return low + (high - low) * torch.rand(count, device=device)


def part_of(pictures, side=FULL):
    """A random part of each picture, often all of it, mirrored or not, seldom turned a little."""
    count, device = len(pictures), pictures.device
    whole = torch.rand(count, device=device) < 0.35
    scale = torch.where(whole, torch.ones(count, device=device), uniform(count, 0.45, 1, device))
    stretch = torch.where(whole, torch.ones(count, device=device), uniform(count, 0.8, 1.25, device))
    wide, high = (scale * stretch).clamp(max=1), (scale / stretch).clamp(max=1)
    angle = uniform(count, -0.25, 0.25, device) * (torch.rand(count, device=device) < 0.2)
    mirror = torch.where(torch.rand(count, device=device) < 0.5, 1.0, -1.0)
    across = uniform(count, -1, 1, device) * (1 - wide)
    down = uniform(count, -1, 1, device) * (1 - high)
    rows = [
        torch.stack([mirror * wide * angle.cos(), -high * angle.sin(), across], 1),
        torch.stack([mirror * wide * angle.sin(), high * angle.cos(), down], 1),
    ]
    return warp(pictures, torch.stack(rows, 1), side)


def warp(pictures, places, side, beyond="reflection"):
    grid = functional.affine_grid(places, [len(pictures), pictures.shape[1], side, side], align_corners=False)
    return functional.grid_sample(pictures, grid, padding_mode=beyond, align_corners=False)


def with_other_subjects(pictures, other, maps, share=0.35):
    """Lays the subject of another picture over some pictures, smaller or larger, anywhere.

    other, maps: pictures and what the teacher found in them, at any side
    """
    count, device = len(pictures), pictures.device
    side = pictures.shape[-1]
    size = uniform(count, 0.7, 2.2, device)  # times smaller
    none = torch.zeros(count, device=device)
    rows = [
        torch.stack([size, none, uniform(count, -0.9, 0.9, device)], 1),
        torch.stack([none, size, uniform(count, -0.9, 0.9, device)], 1),
    ]
    maps = functional.interpolate(maps, size=other.shape[-2:], mode="bilinear", align_corners=False)
    both = torch.cat([other, maps], 1)
    laid = warp(both, torch.stack(rows, 1), side, beyond="zeros")
    cover = ((laid[:, 3:] - 0.4) * 5).clamp(0, 1) * chance(count, share, device)
    return cover * laid[:, :3] + (1 - cover) * pictures


def in_other_light(pictures):
    """Other brightness, contrast, colour and sharpness. The teacher does not see this."""
    count, device = len(pictures), pictures.device

    def factor(low, high):
        return uniform(count, low, high, device).view(-1, 1, 1, 1)

    pictures = pictures.clamp(min=1e-3) ** factor(0.7, 1.4)
    middle = pictures.mean(dim=(1, 2, 3), keepdim=True)
    pictures = (pictures - middle) * factor(0.6, 1.3) + middle * factor(0.7, 1.2)
    gray = pictures.mean(dim=1, keepdim=True)
    colour = factor(0.5, 1.4) * (1 - chance(count, 0.08, device))
    pictures = gray + (pictures - gray) * colour
    pictures = pictures * (1 + 0.15 * (torch.rand(count, 3, 1, 1, device=device) - 0.5))
    soft = functional.avg_pool2d(pictures, 3, 1, 1, count_include_pad=False)
    pictures = torch.lerp(pictures, soft, chance(count, 0.2, device))
    noise = torch.randn_like(pictures) * factor(0, 0.03) * chance(count, 0.3, device)
    return (pictures + noise).clamp(0, 1)

"""The student: a small network of nested U's at half the resolution of its input, of 160 px."""

import torch
import torch.nn as nn
import torch.nn.functional as functional

SIDE = 160  # px, of the input and of the map


def enlarge(tensor):
    return functional.interpolate(tensor, scale_factor=2, mode="bilinear", align_corners=False)


class Layer(nn.Sequential):
    """A convolution of 3 x 3, normalised and rectified."""

    def __init__(self, inputs, outputs, stride=1, dilation=1):
        super().__init__(
            nn.Conv2d(inputs, outputs, 3, stride, dilation, dilation, bias=False),
            nn.BatchNorm2d(outputs),
            nn.ReLU(inplace=True),
        )


class NestedU(nn.Module):
    """A stage: a U of `depth` levels within it, added to what enters it (the residual U-block of U2-Net)."""

    def __init__(self, inputs, middle, outputs, depth):
        super().__init__()
        self.enter = Layer(inputs, outputs)
        self.down = nn.ModuleList([Layer(outputs if i == 0 else middle, middle) for i in range(depth)])
        self.bottom = Layer(middle, middle, dilation=2)
        self.up = nn.ModuleList(
            [Layer(2 * middle, outputs if i == 0 else middle) for i in range(depth)]
        )

    def forward(self, tensor):
        entered = self.enter(tensor)
        levels = []
        now = entered
        for i, layer in enumerate(self.down):
            now = layer(functional.max_pool2d(now, 2, 2) if i > 0 else now)
            levels.append(now)
        now = self.bottom(now)
        for i in reversed(range(len(levels))):
            now = self.up[i](torch.cat([now, levels[i]], 1))
            if i > 0:
                now = enlarge(now)
        return now + entered


class FlatU(nn.Module):
    """The same for the coarsest stages, with dilations in place of smaller levels."""

    def __init__(self, inputs, middle, outputs):
        super().__init__()
        self.enter = Layer(inputs, outputs)
        self.near = Layer(outputs, middle)
        self.far = Layer(middle, middle, dilation=2)
        self.leave = Layer(2 * middle, outputs)

    def forward(self, tensor):
        entered = self.enter(tensor)
        near = self.near(entered)
        return self.leave(torch.cat([self.far(near), near], 1)) + entered


class Student(nn.Module):
    """Takes N x 3 x 160 x 160, as teacher.normal() gives them, and gives the map before the sigmoid."""

    def __init__(self, width=28, middle=12):
        super().__init__()
        self.fine = Layer(3, 8)
        self.begin = Layer(3, width, stride=2)
        self.encoder = nn.ModuleList(
            [
                NestedU(width, middle, width, 4),
                NestedU(width, middle, width, 3),
                NestedU(width, middle, width, 2),
                FlatU(width, middle, width),
                FlatU(width, middle, width),
            ]
        )
        self.decoder = nn.ModuleList(
            [
                NestedU(2 * width, middle, width, 4),
                NestedU(2 * width, middle, width, 3),
                NestedU(2 * width, middle, width, 2),
                FlatU(2 * width, middle, width),
            ]
        )
        self.sides = nn.ModuleList([nn.Conv2d(width, 1, 3, 1, 1) for _ in range(5)])
        self.narrow = Layer(width, 8)
        self.join = Layer(16, 8)
        self.final = nn.Conv2d(8, 1, 3, 1, 1)

    def stages(self, pictures):
        """The ends of the encoder's stages and of the decoder's, the finest first."""
        encoded = []
        now = self.begin(pictures)
        for i, stage in enumerate(self.encoder):
            now = stage(functional.max_pool2d(now, 2, 2) if i > 0 else now)
            encoded.append(now)
        decoded = [None] * len(self.decoder)
        for i in reversed(range(len(self.decoder))):
            now = self.decoder[i](torch.cat([enlarge(now), encoded[i]], 1))
            decoded[i] = now
        return encoded, decoded

    def map_of(self, pictures, decoded):
        joined = torch.cat([enlarge(self.narrow(decoded[0])), self.fine(pictures)], 1)
        return self.final(self.join(joined))

    def forward(self, pictures):
        _, decoded = self.stages(pictures)
        return self.map_of(pictures, decoded)


class Answer(nn.Module):
    """The student as the analyzer runs it, with the sigmoid."""

    def __init__(self, student):
        super().__init__()
        self.student = student

    def forward(self, pictures):
        return torch.sigmoid(self.student(pictures))

"""The teacher: u2netp, read from its ONNX file and run by PyTorch, so that it runs on a graphics card."""

import onnx
import onnx.numpy_helper
import torch
import torch.nn.functional as functional


def stretch(maps):
    """The analyzer stretches each map to [0, 1] unless it is nearly the same everywhere; so do we.

    maps: N x 1 x H x W
    """
    low = maps.amin(dim=(2, 3), keepdim=True)
    high = maps.amax(dim=(2, 3), keepdim=True)
    return (maps - low) / (high - low).clamp(min=0.1)


def normal(pictures):
    """Pictures as the networks take them: each channel less ImageNet's mean, over ImageNet's deviation."""
    mean = pictures.new_tensor([0.485, 0.456, 0.406]).view(1, 3, 1, 1)
    deviation = pictures.new_tensor([0.229, 0.224, 0.225]).view(1, 3, 1, 1)
    return (pictures - mean) / deviation


class OnnxGraph:
    """Runs the few operators of u2netp's file. Sums of two tensors are kept: they end its stages."""

    def __init__(self, file, device, number):
        graph = onnx.load(file).graph
        self.nodes = graph.node
        self.input = next(i.name for i in graph.input if i.name not in {w.name for w in graph.initializer})
        self.output = graph.output[0].name
        self.weights = {}
        for weight in graph.initializer:
            tensor = torch.from_numpy(onnx.numpy_helper.to_array(weight).copy())
            self.weights[weight.name] = tensor.to(device, number) if tensor.is_floating_point() else tensor
        self.last_uses = {name: i for i, node in enumerate(graph.node) for name in node.input}
        self.attributes = [
            {a.name: onnx.helper.get_attribute_value(a) for a in node.attribute} for node in graph.node
        ]

    def run(self, pictures):
        """Gives the map and the ends of the stages: six of the encoder, then five of the decoder."""
        values = dict(self.weights)
        values[self.input] = pictures
        stages = []
        for i, (node, attributes) in enumerate(zip(self.nodes, self.attributes)):
            inputs = [values[name] if name else None for name in node.input]
            value = self.apply(node.op_type, inputs, attributes)
            for name in set(node.input):
                if self.last_uses[name] == i:
                    values.pop(name, None)
            values[node.output[0]] = value
            if node.op_type == "Add":
                stages.append(value)
        return values[self.output], stages

    @staticmethod
    def apply(operator, inputs, attributes):
        if operator == "Conv":
            edge = attributes["pads"][:2]
            return functional.conv2d(
                *inputs, stride=attributes["strides"], padding=edge, dilation=attributes["dilations"]
            )
        if operator == "Relu":
            return functional.relu(inputs[0])
        if operator == "Add":
            return inputs[0] + inputs[1]
        if operator == "Sigmoid":
            return torch.sigmoid(inputs[0])
        if operator == "MaxPool":
            return functional.max_pool2d(inputs[0], 2, 2, ceil_mode=True)
        if operator == "Resize":
            size = [int(n) for n in inputs[3][2:]]
            return functional.interpolate(inputs[0], size=size, mode="bilinear", align_corners=False)
        return OnnxGraph.apply_to_sizes(operator, inputs, attributes)

    @staticmethod
    def apply_to_sizes(operator, inputs, attributes):
        if operator == "Constant":
            return torch.from_numpy(onnx.numpy_helper.to_array(attributes["value"]).copy())
        if operator == "Shape":
            return torch.tensor(inputs[0].shape)
        if operator == "Gather":
            return inputs[0][inputs[1]]
        if operator == "Unsqueeze":
            return inputs[0].unsqueeze(0)
        if operator == "Concat":
            return torch.cat(inputs, dim=attributes["axis"])
        if operator == "Slice":
            return inputs[0][int(inputs[1]) : min(int(inputs[2]), len(inputs[0]))]
        if operator == "Cast":
            return inputs[0]
        raise ValueError(f"the teacher has an operator that is not known here: {operator}")


class Teacher:
    """The subject as photos of the analyzer get it: the mean of a look at 320 px and one at 160 px."""

    def __init__(self, file, device):
        self.number = torch.float16 if device.type == "cuda" else torch.float32
        self.graph = OnnxGraph(file, device, self.number)

    @torch.no_grad()
    def look(self, pictures):
        """pictures: N x 3 x 320 x 320 in [0, 1]. Gives maps of 160 px, and the stages of the large look."""
        pictures = normal(pictures).to(self.number).contiguous(memory_format=torch.channels_last)
        full, stages = self.graph.run(pictures)
        coarse, _ = self.graph.run(functional.avg_pool2d(pictures, 2))
        full = stretch(full.float())
        return (functional.avg_pool2d(full, 2) + stretch(coarse.float())) / 2, stages

#pragma once

namespace vitrine::player {

/// Switches off two paths of Mesa's software renderer (llvmpipe). By one, in Mesa 22.3, a translucent
/// triangle leaves out tiles of 64 x 64 px that it covers completely. The other reads textures with steps of
/// 8 bits, so that pixels are up to 3 levels of grey off. Mesa reads the variables LP_PERF and GALLIVM_PERF
/// of the environment when EGL opens llvmpipe; graphics cards ignore them. Words that the user has put there
/// stay.
///
/// Call this before any thread starts, and before EGL is opened. A second call changes nothing.
void set_mesa_options();

}  // namespace vitrine::player

#pragma once

namespace vitrine::player {

/// Switches off a path of Mesa's software renderer (llvmpipe) that draws wrongly: in Mesa 22.3 a translucent
/// triangle leaves out tiles of 64 x 64 px that it covers completely. Mesa reads the variable LP_PERF of the
/// environment when EGL opens llvmpipe; graphics cards ignore it. Words that the user has put there stay.
///
/// Call this before any thread starts, and before EGL is opened. A second call changes nothing.
void set_mesa_options();

}  // namespace vitrine::player

#include "DropInCase.h"

namespace shadow::test
{

// ROWS THAT ARE SWITCHED OFF, by what breaks the law there. Whoever mends it takes the rows from here; the
// tests hold them to the law from then on. With SHADOW_TEST_SWITCHED_OFF in the environment they are tested
// all the same, and tell how many pixels differ.
const std::vector<KnownDifference>& knownDifferences()
{
  constexpr unsigned drawn = everyWay & ~Selecting;
  static const std::vector<KnownDifference> list{
      {drawn,
       "translucent props are drawn one after the other, where a renderer without a pass has them drawn by a "
       "vtkOrderIndependentTranslucentPass",
       {"translucent",
        "translucent_three",
        "translucent_three_backwards",
        "translucent_intersecting",
        "translucent_mesh_around_opaque",
        "translucent_only",
        "translucent_table",
        "translucent_texture",
        "translucent_colours",
        "translucent_forced",
        "translucent_wireframe",
        "translucent_edges",
        "translucent_backs_culled",
        "translucent_physically_based",
        "glyphs_translucent",
        "image_actor_translucent",
        "volume_and_glass",
        "blocks_translucent",
        "blocks_of_their_own_colours",
        "billboard_text",
        "text_3d",
        "fxaa_and_glass",
        "ssao_and_glass",
        "stereo_anaglyph_of_glass",
        "layers_glass_above",
        "half_transparent_background_and_glass",
        "multisampled_glass",
        "tiles_of_glass",
        "below_a_camera_and_glass"}},
      {drawn,
       "vtkRenderer::UseDepthPeeling and UseDepthPeelingForVolumes are obeyed where a renderer draws without "
       "a pass",
       {"depth_peeling", "depth_peeling_one_peel", "depth_peeling_of_volumes"}},
      {drawn,
       "vtkRenderer::UseFXAA is obeyed where a renderer draws without a pass",
       {"fxaa", "fxaa_and_glass"}},
      {drawn,
       "vtkRenderer::UseSSAO is obeyed where a renderer draws without a pass",
       {"ssao_narrow", "ssao_wide", "ssao_blurred", "ssao_and_glass"}},
      {drawn,
       "vtkRenderer::UseHiddenLineRemoval is obeyed where a renderer draws without a pass",
       {"hidden_lines_removed", "ssao_and_hidden_lines_removed"}},
      {everyWay,
       "vtkOpenGLCamera::Render tells the camera that there are two eyes; vtkCameraPass does not call it",
       {"stereo_red_blue", "stereo_anaglyph", "stereo_interlaced", "stereo_left", "stereo_right",
        "stereo_dresden", "stereo_checkerboard", "stereo_side_by_side", "stereo_anaglyph_parallel",
        "stereo_anaglyph_of_glass"}},
      {drawn,
       "vtkOpenGLCamera::Render obeys the camera's scissor, for one picture; vtkCameraPass does not call it",
       {"scissored"}},
      {everyWay,
       "a pass that is not the renderer's own takes it that a camera pass is above it, which sets the "
       "viewport and "
       "erases; there is none",
       {"alone_in_a_sequence", "ssaa_above", "edl_above", "gaussian_blur_above", "sobel_above",
        "tone_mapping_above", "outline_glow_above", "fxaa_pass_above", "ssao_pass_above", "motion_blur_above",
        "panorama_above"}},
      {Selecting,
       "the selector is handed all props of the renderer, not vtkViewport::PickFromProps",
       {"picked_from_the_table_alone"}},
      {Additive,
       "a lighting pass adds what has the depth that is there, twice where an actor draws two fragments at "
       "one "
       "depth: lines and points that overlap, triangles in one plane",
       {"wireframe", "wireframe_wide", "lines_as_tubes", "points", "points_large", "points_as_spheres",
        "pulled_towards_the_eye", "multisampled_wires", "smoothed_lines"}},
      {Additive,
       "actors inside of a vtkSkybox or vtkAxesActor do not get its property keys, so that VTK does not call "
       "for "
       "their shaders: they are drawn whole in each lighting pass, and added",
       {"skybox", "axes"}},
      {Additive,
       "what is not opaque in VTK's opaque pass is blended there, and its lighting added whole",
       {"force_opaque"}},
      {Additive,
       "a vtkSSAOPass has positions and normals drawn beside colours, and a lighting pass adds to these as "
       "well",
       {"ssao_pass_above_a_camera"}},
      {Additive | NoCasters,
       "VTK switches the depth test on where it erases. Without it, what is drawn last is seen, and the mask "
       "is that "
       "of what is nearest",
       {"erase_off", "window_erase_off"}},
      {NoCasters,
       "the mask has one answer for a pixel, of the surface in front: others that share the pixel take it",
       {"force_opaque", "multisampled", "multisampled_wires", "edges_as_tubes"}},
  };
  return list;
}

} // namespace shadow::test

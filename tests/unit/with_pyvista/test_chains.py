"""Exact shadows and PyVista's own passes: both are in the picture, in whatever order they were asked for.

Usage: test_chains.py [-v] [TestChains.test_NAME]
"""

import itertools
import unittest

from scenes import PASSES, PyVistaTest, drawn, lines, make_plotter, off, picture, shadows, vtk


def nothing_cast(plotter):
    plotter.exact_shadows.enable(intensity=0)


def shadows_off(plotter):
    plotter.exact_shadows.disable()


def maps_on(plotter):
    plotter.enable_shadows()


def maps_off(plotter):
    plotter.disable_shadows()


def combinations():
    """Those that PyVista allows: not SSAO with depth of field, and one kind of anti-aliasing."""
    yield "ssao", "ssaa", "blur"
    yield "edl", "ssaa", "dof", "blur"
    for names in (*((name,) for name in PASSES), *itertools.combinations(PASSES, 2)):
        if names != ("ssao", "dof") and len({"ssaa", "fxaa", "msaa"} & set(names)) < 2:
            yield names


class TestChains(PyVistaTest):
    def check_both(self, ours, touched, steps, **arguments):
        plotter = make_plotter()
        for step in steps:
            step(plotter)
        self.assert_both(ours, plotter, touched, **arguments)
        plotter.close()

    def test_every_combination_and_order(self):
        for names in combinations():
            theirs = [PASSES[name][0] for name in names]
            # VTK's SSAO over EDL varies from picture to picture.
            reach = None if {"ssao", "edl"} <= set(names) else 12
            for at in range(len(theirs) + 1):
                with self.subTest(names=names, at=at):
                    self.check_both("the shadow", self.shadowed, [*theirs[:at], shadows, *theirs[at:]],
                                    reach=reach)

    def test_lines_too(self):
        for name, (enable, _) in PASSES.items():
            with self.subTest(name=name):
                self.check_both("the line", self.lined, [lines, enable])
                self.check_both("the line", self.lined, [enable, lines])
                self.check_both("the line", self.lined, [shadows, enable, picture, lines, shadows_off])

    def test_the_order_makes_no_difference(self):
        for name, (enable, _) in PASSES.items():
            if name != "dof":  # VTK's own depends on what has been drawn before
                with self.subTest(name=name):
                    self.assert_same(drawn(shadows, lines, enable), drawn(enable, lines, shadows))
                    self.assert_same(drawn(shadows, picture, enable, lines), drawn(enable, lines, shadows))

    def test_off_and_no_intensity_are_plain(self):
        for name, (enable, disable) in PASSES.items():
            plotter = make_plotter()
            enable(plotter)
            without = picture(plotter)
            with self.subTest(name=name):
                nothing_cast(plotter)
                self.assert_same(picture(plotter), without, "no intensity")
                for ours in (shadows, lines):
                    ours(plotter)
                    self.assert_other(picture(plotter), without)
                    off(plotter)
                    self.assert_same(picture(plotter), without, "off")
                shadows(plotter)
                disable(plotter)
                self.assert_same(picture(plotter), drawn(enable, disable, shadows), "theirs off")
                off(plotter)
                self.assert_same(picture(plotter), drawn(enable, disable), "both off")
            plotter.close()

    def test_shadow_maps_give_way(self):
        # Without glass, which some versions of PyVista go on to draw in another way after disable_shadows().
        exact, maps = drawn(shadows, glass=False), drawn(maps_on, glass=False)
        self.assert_other(maps, exact)
        self.assert_same(drawn(maps_on, shadows, glass=False), exact)
        self.assert_same(drawn(shadows, maps_on, glass=False), exact)
        self.assert_same(drawn(shadows, maps_on, picture, off, glass=False), maps)
        self.assert_same(drawn(shadows, maps_on, picture, maps_off, glass=False), exact)

    def test_lines_go_over_shadow_maps(self):
        for steps in ([maps_on, lines], [lines, maps_on]):
            with self.subTest():
                plotter = make_plotter()
                for step in steps:
                    step(plotter)
                self.assert_both("the line", plotter, self.lined, 1)
                plotter.close()

    def test_an_own_chain(self):
        def chain(plotter):
            steps, passes = vtk.vtkRenderStepsPass(), vtk.vtkRenderPassCollection()
            for step in ("Lights", "Opaque", "Translucent", "Overlay"):
                passes.AddItem(getattr(steps, f"Get{step}Pass")())
            sequence, camera, blur = vtk.vtkSequencePass(), vtk.vtkCameraPass(), vtk.vtkGaussianBlurPass()
            sequence.SetPasses(passes)
            camera.SetDelegatePass(sequence)
            blur.SetDelegatePass(camera)
            plotter.renderer.SetPass(blur)

        self.check_both("the shadow", self.shadowed, [chain, shadows])
        self.check_both("the shadow", self.shadowed, [shadows, chain])

    def test_a_chain_that_becomes_unknown_is_given_back(self):
        plotter = make_plotter()
        steps, passes = vtk.vtkRenderStepsPass(), vtk.vtkRenderPassCollection()
        passes.AddItem(steps)
        sequence, camera = vtk.vtkSequencePass(), vtk.vtkCameraPass()
        sequence.SetPasses(passes)
        camera.SetDelegatePass(sequence)
        plotter.renderer.SetPass(camera)
        shadows(plotter)
        self.assertIsNot(camera.GetDelegatePass(), sequence)
        passes.RemoveItem(steps)
        picture(plotter)
        self.assertIs(camera.GetDelegatePass(), sequence)
        self.assertIn("not drawn", plotter.exact_shadows.status)
        plotter.close()

    def test_an_unknown_chain_is_left_alone(self):
        plotter = make_plotter()
        camera = vtk.vtkCameraPass()
        camera.SetDelegatePass(vtk.vtkRenderStepsPass().GetOverlayPass())
        plotter.renderer.SetPass(camera)
        without = picture(plotter)
        plotter.exact_shadows.enable()
        self.assert_same(picture(plotter), without)
        self.assertIn("not drawn", plotter.exact_shadows.status)
        plotter.close()

    def test_toggled_often(self):
        plotter = make_plotter()
        component = plotter.exact_shadows
        enable_blur, disable_blur = PASSES["blur"]
        enable_ssaa, disable_ssaa = PASSES["ssaa"]

        def toggle():
            component.enable()
            component.outlines()
            enable_blur(plotter)
            plotter.render_window.Render()
            component.disable()
            enable_ssaa(plotter)
            plotter.render_window.Render()
            disable_blur(plotter)
            component.enable()
            disable_ssaa(plotter)
            component.outlines(None)
            plotter.render_window.Render()

        def counts():
            base = plotter.renderer._render_passes._camera_pass
            return [each.GetReferenceCount() for each in (component.shadow_pass, component.outline_pass, base,
                                                          base.GetDelegatePass(), plotter.renderer)]

        toggle()
        before, shown = counts(), picture(plotter)
        memory = component.shadow_pass.GetMemorySize()
        for _ in range(300):
            toggle()
        self.assertEqual(counts(), before)
        self.assertEqual(component.shadow_pass.GetMemorySize(), memory)
        self.assert_same(picture(plotter), shown)
        component.disable()
        self.assert_same(picture(plotter), self.plain)
        plotter.close()


if __name__ == "__main__":
    unittest.main()

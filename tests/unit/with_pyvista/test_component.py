"""What plotter.exact_shadows promises.

Usage: test_component.py [-v] [TestComponent.test_NAME]
"""

import gc
import unittest
import weakref

from scenes import PyVistaTest, differing, drawn, grown, lines, make_plotter, np, off, picture, pv, shadows

# Calls that cannot be right, and what they raise.
BAD = [
    (lambda c: c.enable(intensity=1.5), ValueError),
    (lambda c: c.enable(intensity=-0.1), ValueError),
    (lambda c: c.enable(intensity=float("nan")), ValueError),
    (lambda c: c.enable(intensity="much"), TypeError),
    (lambda c: c.enable(intensity=True), TypeError),
    (lambda c: c.enable(samples=3), ValueError),
    (lambda c: c.enable(samples=0), ValueError),
    (lambda c: c.enable(samples=2.0), TypeError),
    (lambda c: c.enable(method="magic"), ValueError),
    (lambda c: c.enable(method=3), TypeError),
    (lambda c: c.outlines(0), ValueError),
    (lambda c: c.outlines(100), ValueError),
    (lambda c: c.outlines("thick"), TypeError),
    (lambda c: c.outlines(True), TypeError),
    (lambda c: c.outlines(color="no colour"), ValueError),
    (lambda c: c.outlines(color=object()), ValueError),
    (lambda c: c.outlines(creases=200), ValueError),
    (lambda c: c.outlines(creases="many"), TypeError),
]


class TestComponent(PyVistaTest):
    def setUp(self):
        self.plotter = make_plotter()
        self.component = self.plotter.exact_shadows

    def tearDown(self):
        self.plotter.close()

    def test_there_is_one_for_a_plotter(self):
        self.assertIs(self.plotter.exact_shadows, self.component)
        self.assert_same(picture(self.plotter), self.plain, "it does nothing unasked")
        self.assertEqual(self.component.status, "shadows off; outlines off")

    def test_off_is_plain(self):
        for ours in (shadows, lines):
            ours(self.plotter)
            self.assert_other(picture(self.plotter), self.plain)
            off(self.plotter)
            self.assert_same(picture(self.plotter), self.plain)
            self.assertIsNone(self.plotter.renderer.GetPass())

    def test_each_goes_off_by_itself(self):
        shadows(self.plotter)
        lines(self.plotter)
        self.component.disable()
        self.assert_same(picture(self.plotter), drawn(lines))
        self.component.enable()
        for nothing in (None, False):
            self.component.outlines()
            self.component.outlines(nothing)
            self.assert_same(picture(self.plotter), drawn(shadows))

    def test_no_intensity_is_plain(self):
        self.component.enable(intensity=0)
        self.assert_same(picture(self.plotter), self.plain)

    def test_intensity_is_how_dark_a_shadow_is(self):
        before = self.plain
        for intensity in (0.3, 0.6, 1):
            self.component.enable(intensity=intensity)
            now = picture(self.plotter)
            self.assertTrue((now <= before)[self.shadowed].all())
            self.assert_other(now, before)
            before = now

    def test_methods_give_one_picture(self):
        from vtkshadow.pyvista.settings import METHODS

        self.assertEqual(len(METHODS), self.component.shadow_pass.SILHOUETTE_COMPUTE + 1)
        expected = drawn(shadows)
        for method in METHODS:
            self.component.enable(method=method)
            self.assert_same(picture(self.plotter), expected, method)

    def test_samples_soften_edges(self):
        self.component.enable(samples=8)
        self.assertGreater(set(np.unique(self.component.mask(0))), {0, 255})
        self.component.enable(samples=1)
        self.assertLessEqual(set(np.unique(self.component.mask(0))), {0, 255})

    def test_creases_are_more_lines(self):
        self.plotter.add_mesh(pv.Cube(center=(-1, 0.8, 0)), color="white")
        without = picture(self.plotter)
        self.component.outlines()
        few = differing(picture(self.plotter), without)
        self.component.outlines(creases=40)
        many = differing(picture(self.plotter), without)
        self.assertTrue(many[few].all())
        self.assertGreater(int(many.sum()), int(few.sum()) + 50)
        self.component.outlines(creases=None)
        self.assertTrue((differing(picture(self.plotter), without) == few).all())

    def test_lines_are_as_wide_and_as_coloured_as_asked_for(self):
        counts = []
        for width in (2, 4, 8):
            self.component.outlines(width, (1.0, 0.0, 0.0))
            now = picture(self.plotter)
            counts.append(int(differing(now, self.plain).sum()))
            self.assertGreater(int((now == (255, 0, 0)).all(axis=2).sum()), 50)
        self.assertTrue(1.3 * counts[0] < counts[1] and 1.5 * counts[1] < counts[2], counts)

    def test_lines_keep_their_width_below_supersampling(self):
        self.component.outlines(4, "red")
        alone = (picture(self.plotter) == (255, 0, 0)).all(axis=2).sum()
        self.plotter.enable_anti_aliasing("ssaa")
        below = (picture(self.plotter) == (255, 0, 0)).all(axis=2).sum()
        self.assertLess(abs(int(alone) - int(below)), 0.25 * alone)

    def test_mask(self):
        self.component.enable()
        mask = self.component.mask(0)  # of a plotter that has drawn nothing yet
        self.assertEqual((mask.shape, mask.dtype), (self.plain.shape[:2], np.uint8))
        self.assertTrue((mask[self.shadowed] == 0).all(), "what has become darker is in shadow")
        self.assertGreater(int(self.shadowed.sum()), 200)
        self.assertTrue((self.component.mask(1) == 255).all(), "a headlight has no shadow")
        for number, light in enumerate(self.plotter.renderer.lights):
            self.assertTrue((self.component.mask(light) == self.component.mask(number)).all())
        self.plotter.renderer.lights[0].switch_off()
        self.assertTrue((self.component.mask(0) == 255).all(), "lights that are off do not count")

    def test_mask_of_what_is_no_light(self):
        with self.assertRaisesRegex(RuntimeError, "off"):
            self.component.mask(0)
        self.component.enable()
        for light, error in ((2, ValueError), (-1, ValueError), ("lamp", TypeError), (True, TypeError),
                             (None, TypeError), (0.0, TypeError), (pv.Light(), TypeError)):
            with self.assertRaises(error):
                self.component.mask(light)

    def test_bad_arguments_change_nothing(self):
        self.component.enable(0.5)
        lines(self.plotter)
        before, shown = self.component.settings, picture(self.plotter)
        for index, (call, error) in enumerate(BAD):
            for target in (self.component, self.component.all):
                with self.subTest(index=index), self.assertRaises(error) as raised:
                    call(target)
                self.assertLess(len(str(raised.exception)), 300)
        self.assertEqual(self.component.settings, before)
        self.assert_same(picture(self.plotter), shown)

    def test_status_tells_what_is_missing(self):
        self.component.enable()
        self.component.outlines()
        self.assertEqual(self.component.status, "shadows on, not drawn yet; outlines on, not drawn yet")
        picture(self.plotter)
        self.assertEqual(self.component.status, "shadows on; outlines on")
        self.plotter.enable_shadows()
        picture(self.plotter)
        self.assertIn("shadow maps are left out", self.component.status)
        self.plotter.disable_shadows()
        self.plotter.renderer.lights[0].switch_off()
        picture(self.plotter)
        self.assertIn("no light casts", self.component.status)

    def test_status_tells_of_what_is_unlit(self):
        self.plotter.clear_actors()
        self.plotter.add_mesh(pv.Sphere(), lighting=False)
        self.plotter.add_floor("-z")
        self.component.enable()
        picture(self.plotter)
        self.assertIn("lighting of all is off", self.component.status)
        self.assertIn("lighting=True", self.component.status)

    def test_subplots(self):
        self.plotter.close()
        self.plotter = make_plotter(shape=(1, 2))
        component = self.plotter.exact_shadows
        plain = picture(self.plotter)
        halves = [np.s_[:, :plain.shape[1] // 2], np.s_[:, plain.shape[1] // 2:]]
        component.all.enable()
        component.all.outlines(3, "red")
        everywhere = picture(self.plotter)
        component.all.disable()
        component.all.outlines(False)
        self.assert_same(picture(self.plotter), plain)
        for index, other in ((0, 1), (1, 0)):
            self.plotter.subplot(0, index)
            component.enable()
            component.outlines(3, "red")
            now = picture(self.plotter)
            self.assert_same(now[halves[index]], everywhere[halves[index]])
            self.assert_same(now[halves[other]], plain[halves[other]])
            self.assertEqual(component.status, "shadows on; outlines on")
            self.assertEqual(component.mask(0).shape, now[halves[index]].shape[:2])
            off(self.plotter)
        self.assert_same(picture(self.plotter), plain)
        self.assertEqual(component.all.status.splitlines(), ["shadows off; outlines off"] * 2)

    def test_drawn_into_a_window_of_another_size(self):
        shadows(self.plotter)
        picture(self.plotter)
        self.plotter.window_size = (150, 200)
        now = picture(self.plotter)
        self.assertEqual(self.component.mask(0).shape, now.shape[:2])

    def test_closed(self):
        shadows(self.plotter)
        lines(self.plotter)
        picture(self.plotter)
        self.plotter.close()
        for call in (lambda c: c.enable(), lambda c: c.disable(), lambda c: c.outlines(), lambda c: c.mask(0)):
            with self.assertRaisesRegex(RuntimeError, "closed"):
                call(self.component)

    def test_nothing_is_kept_alive(self):
        plotter = make_plotter()
        shadows(plotter)
        lines(plotter)
        picture(plotter)
        kept = weakref.ref(plotter.exact_shadows.active), weakref.ref(plotter.exact_shadows.shadow_pass)
        plotter.close()
        del plotter
        pv.close_all()
        gc.collect()
        self.assertEqual([each() for each in kept], [None, None])
        self.setUpClass()  # close_all() has closed the window that stays

    def test_what_is_set_on_the_passes_stays(self):
        ball = self.plotter.add_mesh(pv.Sphere(radius=0.3, center=(-1, -1, 0.3)))
        self.component.shadow_pass.SetCasting(ball, False)
        shadows(self.plotter)
        without = picture(self.plotter)
        off(self.plotter)
        shadows(self.plotter)
        self.assert_same(picture(self.plotter), without)
        self.component.shadow_pass.SetCasting(ball, True)
        self.assert_other(picture(self.plotter), without)


if __name__ == "__main__":
    unittest.main()

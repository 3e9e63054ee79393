"""The provider for pyvista-render-passes: right with each of its passes, alone and together.

Usage: test_render_passes.py [-v] [TestRenderPasses.test_NAME]
"""

import itertools
import json
import sys
import unittest

from scenes import PyVistaTest, differing, drawn, lines, make_plotter, np, off, picture, shadows

try:
    from pyvista_render_passes import SettingsVetoedError, register_pass_provider
except ImportError as error:
    print(f"there is no pyvista-render-passes: {error}")
    sys.exit(0)

from vtkshadow.pyvista import ExactShadowsProvider

PASSES = {
    "peeling": lambda c: c.enable_depth_peeling(),
    "ssao": lambda c: c.enable_ssao(radius=0.3, kernel_size=16),
    "edl": lambda c: c.enable_edl(),
    "ssaa": lambda c: c.enable_anti_aliasing(),
    "dof": lambda c: c.enable_dof(),
    "blur": lambda c: c.enable_blur(),
}

ON = {"enabled": True}
LINES = {"outlines": {"width": 2, "color": "red"}}


def host(plotter):
    """plotter.render_passes, with our provider in every subplot whether or not its entry point is installed."""
    for index in range(len(plotter.renderers)):
        plotter.subplot(*plotter.renderers.index_to_loc(index))
        if "exact_shadows" not in plotter.render_passes.providers:
            register_pass_provider(plotter, ExactShadowsProvider)
    plotter.subplot(0, 0)
    return plotter.render_passes


def provide(plotter, **state):
    host(plotter).set_state({"providers": {"exact_shadows": state}})


def combinations():
    for count in range(1, len(PASSES) + 1):
        for names in itertools.combinations(PASSES, count):
            if not {"ssao", "dof"} <= set(names):
                yield names


class TestRenderPasses(PyVistaTest):
    def setUp(self):
        self.plotter = make_plotter()
        self.host = host(self.plotter)

    def tearDown(self):
        self.plotter.close()

    def test_off_by_default(self):
        self.assertEqual(self.host.get_state()["providers"]["exact_shadows"]["enabled"], False)
        self.assertEqual(self.host.default_state()["providers"]["exact_shadows"],
                         self.host.get_state()["providers"]["exact_shadows"])
        self.assert_same(picture(self.plotter), self.plain)
        self.assertIsNone(self.plotter.renderer.GetPass())

    def check_with_passes(self, ours, touched, state):
        for names in combinations():
            with self.subTest(names=names):
                plotter = make_plotter()
                for name in names:
                    PASSES[name](host(plotter))
                without = picture(plotter)
                provide(plotter, **state)
                with_ours = picture(plotter)
                changed = differing(with_ours, without)
                self.assertGreater(float(changed[touched].mean()), 0.9, f"{ours} is missing")
                if names != ("peeling",):
                    self.assert_other(without, self.plain, "theirs is missing")
                provide(plotter, enabled=False, outlines=None)
                again = picture(plotter)
                if not {"dof"} & set(names):  # VTK's own varies from picture to picture
                    self.assert_same(again, without, "not off")
                plotter.close()

    def test_shadows_with_every_combination(self):
        self.check_with_passes("the shadow", self.shadowed, ON)

    def test_lines_with_every_combination(self):
        self.check_with_passes("the line", self.lined, LINES)

    def test_no_intensity_is_plain(self):
        for name, enable in PASSES.items():
            if name != "dof":
                with self.subTest(name=name):
                    theirs = drawn(lambda p: enable(host(p)))
                    both = drawn(lambda p: enable(host(p)), lambda p: provide(p, **ON, intensity=0))
                    self.assert_same(both, theirs)

    def test_alone_it_draws_what_the_component_draws(self):
        # Without glass: translucent things are drawn by another pass in a chain than in none.
        for ours, state in ((shadows, ON), (lines, LINES)):
            self.assert_same(drawn(lambda p: provide(p, **state), glass=False), drawn(ours, glass=False))

    def test_lines_follow_supersampling(self):
        provide(self.plotter, outlines={"width": 4, "color": "red"})
        counts = []
        self.host.enable_anti_aliasing(2.0)
        for factor in (2.0, 3.0, 4.0):
            self.host.set_ssaa_factor(factor)
            counts.append(int((picture(self.plotter)[..., 1] < 100).sum()))
        self.assertLess(max(counts) - min(counts), 0.1 * max(counts), counts)

    def test_veto_beside_shadow_maps(self):
        provide(self.plotter, **ON)
        before = self.host.get_state()
        with self.assertRaises(SettingsVetoedError):
            self.host.enable_shadows()
        self.assertEqual(self.host.get_state(), before)
        provide(self.plotter, enabled=False)
        self.host.enable_shadows()
        before = self.host.get_state()
        for call in (lambda: provide(self.plotter, **ON), self.plotter.exact_shadows.enable):
            with self.assertRaises(ValueError):
                call()
            self.assertEqual(self.host.get_state(), before)
        maps = picture(self.plotter)
        self.plotter.exact_shadows.outlines(2, "red")
        self.assertGreater(float(differing(picture(self.plotter), maps)[self.lined].mean()), 0.9)

    def test_all_or_none(self):
        plotter = make_plotter(shape=(1, 2))
        host(plotter)
        plotter.subplot(0, 1)
        plotter.render_passes.enable_shadows()
        states = [each.get_state() for each in plotter.render_passes.components]
        with self.assertRaises(ValueError):
            plotter.exact_shadows.all.enable()
        self.assertEqual([each.get_state() for each in plotter.render_passes.components], states)
        plotter.close()

    def test_state_is_saved_and_restored(self):
        provide(self.plotter, enabled=True, intensity=0.7, samples=4, method="hierarchical",
                outlines={"width": 3, "color": "blue", "creases": 40})
        PASSES["blur"](self.host)
        saved = json.loads(json.dumps(self.host.get_state()))
        other = make_plotter()
        host(other).set_state(saved)
        self.assertEqual(other.render_passes.get_state(), saved)
        self.assert_same(picture(other), picture(self.plotter))
        other.close()

    def test_bad_state_changes_nothing(self):
        provide(self.plotter, **ON)
        before, shown = self.host.get_state(), picture(self.plotter)
        for state in ({"intensity": 2}, {"enabled": 1}, {"samples": 3}, {"method": "magic"}, {"outlines": 3},
                      {"enabled": False, "outlines": {"width": 0}}):
            with self.subTest(state=state), self.assertRaises((TypeError, ValueError)):
                provide(self.plotter, **state)
            self.assertEqual(self.host.get_state(), before)
        self.assert_same(picture(self.plotter), shown)

    def test_subplots(self):
        for names in ((), ("ssao", "ssaa"), ("edl", "blur")):
            plotter = make_plotter(shape=(1, 2))
            for index in (0, 1):
                host(plotter)
                plotter.subplot(0, index)
                for name in names:
                    PASSES[name](plotter.render_passes)
                plotter.render_passes.set_state({"providers": {"exact_shadows": {"enabled": True, "intensity": 0}}})
            without = picture(plotter)
            halves = [np.s_[:, :without.shape[1] // 2], np.s_[:, without.shape[1] // 2:]]
            for index, other in ((0, 1), (1, 0)):
                plotter.subplot(0, index)
                for intensity in (1, 0):
                    plotter.render_passes.set_state({"providers": {"exact_shadows": {"intensity": intensity}}})
                    now = picture(plotter)
                    with self.subTest(names=names, index=index, intensity=intensity):
                        self.assert_same(now[halves[other]], without[halves[other]])
                        check = self.assert_other if intensity else self.assert_same
                        check(now[halves[index]], without[halves[index]])
            plotter.close()

    def test_toggled_often(self):
        PASSES["ssaa"](self.host)
        PASSES["ssao"](self.host)
        effects = self.host.providers["exact_shadows"].effects

        def toggle():
            provide(self.plotter, **ON, **LINES)
            self.plotter.render_window.Render()
            provide(self.plotter, enabled=False, outlines=None)
            self.plotter.render_window.Render()

        def counts():
            return [each.GetReferenceCount() for each in (effects.shadow_pass, effects.outline_pass,
                                                          self.plotter.renderer)]

        without = picture(self.plotter)
        toggle()
        before = counts()
        for _ in range(300):
            toggle()
        self.assertEqual(counts(), before)
        self.assert_same(picture(self.plotter), without)
        provide(self.plotter, **ON)
        self.assert_other(picture(self.plotter), without)

    def test_both_components(self):
        """plotter.exact_shadows and plotter.render_passes, whichever was asked for first."""
        expected = drawn(lambda p: provide(p, **ON), lambda p: host(p).enable_ssao(radius=0.3, kernel_size=16))
        orders = ([shadows, lambda p: PASSES["ssao"](p.render_passes)],
                  [lambda p: PASSES["ssao"](p.render_passes), shadows],
                  [shadows, picture, lambda p: PASSES["ssao"](p.render_passes), picture],
                  [shadows, picture, lambda p: PASSES["ssao"](host(p))],
                  [shadows, picture, lambda p: PASSES["ssao"](host(p)), lambda p: p.render_passes.apply()])
        for index, steps in enumerate(orders):
            with self.subTest(index=index):
                plotter = make_plotter()
                for step in steps:
                    step(plotter)
                self.assert_same(picture(plotter), expected)
                self.assertEqual(plotter.exact_shadows.status, "shadows on; outlines off")
                off(plotter)
                self.assertEqual(plotter.render_passes.get_state()["providers"]["exact_shadows"]["enabled"], False)
                self.assert_same(picture(plotter), drawn(lambda p: PASSES["ssao"](p.render_passes)))
                plotter.close()

    def test_shadow_maps_asked_for_first(self):
        plotter = make_plotter()
        shadows(plotter)
        picture(plotter)
        plotter.render_passes.enable_shadows()
        picture(plotter)
        self.assertIn("shadow maps", plotter.exact_shadows.status)
        plotter.close()


if __name__ == "__main__":
    unittest.main()

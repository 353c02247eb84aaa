package org.hificamsim.tracks;

import static org.hificamsim.core.NamedSetting.setting;

import org.hificamsim.core.Texts;
import org.hificamsim.core.scenario.spec.Field;

/** Finds signs that a floor plan was read at a wrong scale, or with a wrong choice of walls. */
record SiteSigns(DrawnSite site) {
  /** The size below which sites are rare, in metres. */
  private static final double SMALL = 2;

  private static final double LARGE = 2_000;

  /** The size in metres beyond which a site has coordinates in another unit. */
  private static final double HUGE = 50_000;

  void addTo(Plausibility signs) {
    Field field = site.field();
    double longer = Math.max(field.width(), field.height());
    String size = Texts.format("the site is %.0f x %.0f m", field.width(), field.height());
    String cure = "another " + setting("scale") + " or " + setting("walls_unit");
    if (longer > HUGE) {
      signs.fault(size + ": its coordinates probably have another unit", cure);
    } else if (longer < SMALL || longer > LARGE) {
      signs.doubt(size + ", expected " + cure + " if it is not");
    }
    double shareInSolid = WallSigns.shareInSolid(site.obstacles(), site.positions(false).points());
    if (shareInSolid >= WallSigns.NEARLY_ALL) {
      signs.fault(
          Texts.format(
              "a solid fills %.0f %% of the plan: it is probably the area that people walk in, or"
                  + " the background of the page",
              100 * shareInSolid),
          setting("walkable") + ", which makes its border walls, or " + setting("layers"));
    }
  }
}

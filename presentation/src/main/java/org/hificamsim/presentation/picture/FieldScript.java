package org.hificamsim.presentation.picture;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Paint;
import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hificamsim.presentation.plot.Legend;
import org.hificamsim.presentation.plot.LegendEntry;
import org.hificamsim.presentation.replay.ReplayJson;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.presentation.report.Scripts;
import org.mozilla.javascript.Context;
import org.mozilla.javascript.Function;
import org.mozilla.javascript.NativeJSON;
import org.mozilla.javascript.Script;
import org.mozilla.javascript.Scriptable;
import org.mozilla.javascript.ScriptableObject;

/**
 * The script by which pages paint fields, {@code picture.js}, run by Rhino for the pictures of one
 * run: what a field looks like is written once. For one thread at a time.
 */
final class FieldScript {
  private static final String MODULE = "picture.js";
  private static final double SIGN = 5.5; // radius of a legend's sign, points
  private static final int LEGEND_ROW = 24;
  private static final Pattern COLOR = Pattern.compile("--(\\w+): (#[0-9a-f]{6})");
  private static final Script SCRIPT =
      in(context -> context.compileString(Scripts.bundle(MODULE), MODULE, 1, null));

  private final ScriptableObject scope;
  private final Scriptable functions;
  private final Object setup;
  private final Scriptable colors;

  FieldScript(Setup setup) {
    scope = in(Context::initSafeStandardObjects);
    in(context -> SCRIPT.exec(context, scope, scope));
    String name = Scripts.variable(MODULE);
    functions = (Scriptable) in(context -> context.evaluateString(scope, name, name, 1, null));
    this.setup =
        in(
            context ->
                NativeJSON.parse(
                    context, scope, ReplayJson.of(setup), (any, self, that, given) -> given[1]));
    colors = object(lightColors());
  }

  /** The colours of the light theme, which the style sheet has first. */
  private static Map<String, String> lightColors() {
    Map<String, String> colors = new HashMap<>();
    Matcher found = COLOR.matcher(Scripts.text("style.css"));
    while (found.find()) {
      colors.putIfAbsent(found.group(1), found.group(2));
    }
    return colors;
  }

  /** How high the field is in a picture of this width, points. */
  double height(double width) {
    return ((Number) call("height", setup, width)).doubleValue();
  }

  /** Colours from the least of a heat map's scale to the most, as they are seen on white. */
  List<Color> scale(int count) {
    return ((List<?>) call("scale", count)).stream().map(FieldScript::color).toList();
  }

  private static Color color(Object parts) {
    int[] rgb = ((List<?>) parts).stream().mapToInt(part -> ((Number) part).intValue()).toArray();
    return new Color(rgb[0], rgb[1], rgb[2]);
  }

  /** How a heat map fills what no camera ever covers. */
  Paint never() {
    return (Paint) Context.jsToJava(call("never", new ScriptCanvas(null)), Paint.class);
  }

  /** What the signs in a picture mean, group by group. */
  Legend legend(Look look, int width) {
    Object groups = call("signs", setup, colors, look.zones().orElse(-1), new ScriptCanvas(null));
    return new Legend(
        ((List<?>) groups)
            .stream().map(group -> ((List<?>) group).stream().map(this::entry).toList()).toList(),
        width,
        (int) (2 * SIGN),
        LEGEND_ROW);
  }

  private LegendEntry entry(Object entry) {
    Map<?, ?> properties = (Map<?, ?>) entry;
    String label = properties.get("label").toString();
    Function mark = (Function) properties.get("mark");
    return mark == null
        ? new LegendEntry(label, null)
        : new LegendEntry(
            label, (graphics, x, y) -> call(mark, new ScriptCanvas(graphics), x + SIGN, y, SIGN));
  }

  /**
   * Paints a frame of a run within an area.
   *
   * @param heat a heat map or the cells of a plan, painted in its place; null for none
   * @param values of the heat map's cells
   */
  void paint(
      Graphics2D graphics,
      Rectangle2D area,
      RunFrames run,
      int index,
      Record heat,
      double[] values) {
    Graphics2D place = (Graphics2D) graphics.create();
    place.clip(area);
    place.translate(area.getX(), area.getY());
    call(
        "paint",
        new ScriptCanvas(place),
        setup,
        colors,
        area.getWidth(),
        area.getHeight(),
        object(run.columns(index)),
        ReplayJson.of(run.poses(index)),
        run.floor(),
        run.look().floor(),
        run.look().zones().orElse(-1),
        run.look().tracks(),
        heat == null ? null : ReplayJson.of(heat),
        values);
    place.dispose();
  }

  private Scriptable object(Map<String, ?> properties) {
    return in(
        context -> {
          Scriptable object = context.newObject(scope);
          properties.forEach(
              (name, value) -> object.put(name, object, Context.javaToJS(value, scope)));
          return object;
        });
  }

  private Object call(String function, Object... arguments) {
    return call((Function) ScriptableObject.getProperty(functions, function), arguments);
  }

  private Object call(Function function, Object... arguments) {
    return in(
        context -> {
          Object[] values =
              Arrays.stream(arguments).map(value -> Context.javaToJS(value, scope)).toArray();
          return function.call(context, scope, functions, values);
        });
  }

  private static <T> T in(java.util.function.Function<Context, T> task) {
    try (Context context = Context.enter()) {
      context.setLanguageVersion(Context.VERSION_ES6);
      context.setInterpretedMode(true); // compiling takes longer than even an animation gains
      return task.apply(context);
    }
  }
}

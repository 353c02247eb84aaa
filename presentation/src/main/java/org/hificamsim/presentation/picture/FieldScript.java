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
 * Paints the pictures of one run by the script that paints fields on pages, {@code picture.js}. It
 * is not thread-safe.
 */
final class FieldScript {
  private static final String MODULE = "picture.js";

  /** The radius of a legend's signs, in points. */
  private static final double SIGN_RADIUS = 5.5;

  private static final int LEGEND_ROW = 24;
  private static final Pattern COLOR = Pattern.compile("--(\\w+): (#[0-9a-f]{6})");
  private static final Script SCRIPT =
      run(context -> context.compileString(Scripts.bundle(MODULE), MODULE, 1, null));

  private final ScriptableObject scope;
  private final Scriptable functions;
  private final Object setup;
  private final Scriptable colors;

  FieldScript(Setup setup) {
    scope = run(Context::initSafeStandardObjects);
    run(context -> SCRIPT.exec(context, scope, scope));
    String name = Scripts.variable(MODULE);
    functions = (Scriptable) run(context -> context.evaluateString(scope, name, name, 1, null));
    this.setup =
        run(
            context ->
                NativeJSON.parse(
                    context,
                    scope,
                    ReplayJson.of(setup),
                    (call, self, receiver, arguments) -> arguments[1]));
    colors = object(lightColors());
  }

  /** Returns the colours of the light theme, which comes first in the style sheet. */
  private static Map<String, String> lightColors() {
    Map<String, String> colors = new HashMap<>();
    Matcher declaration = COLOR.matcher(Scripts.text("style.css"));
    while (declaration.find()) {
      colors.putIfAbsent(declaration.group(1), declaration.group(2));
    }
    return colors;
  }

  /** Returns the height of the field in a picture of a width, in points. */
  double height(double width) {
    return ((Number) call("height", setup, width)).doubleValue();
  }

  /** Returns colours of a heat map's scale on white, from the least value to the greatest. */
  List<Color> scale(int count) {
    return ((List<?>) call("scale", count)).stream().map(FieldScript::color).toList();
  }

  private static Color color(Object parts) {
    int[] rgb = ((List<?>) parts).stream().mapToInt(part -> ((Number) part).intValue()).toArray();
    return new Color(rgb[0], rgb[1], rgb[2]);
  }

  /** Returns the paint of a heat map's cells that no camera ever covers. */
  Paint neverCovered() {
    return (Paint) Context.jsToJava(call("never", new ScriptCanvas(null)), Paint.class);
  }

  /** Returns the legend of a picture. */
  Legend legend(Look look, int width) {
    Object groups = call("signs", setup, colors, densityCamera(look), new ScriptCanvas(null));
    return new Legend(
        ((List<?>) groups)
            .stream().map(group -> ((List<?>) group).stream().map(this::entry).toList()).toList(),
        width,
        (int) (2 * SIGN_RADIUS),
        LEGEND_ROW);
  }

  private LegendEntry entry(Object entry) {
    Map<?, ?> properties = (Map<?, ?>) entry;
    String label = properties.get("label").toString();
    Function mark = (Function) properties.get("mark");
    return mark == null
        ? new LegendEntry(label, null)
        : new LegendEntry(
            label,
            (graphics, x, y) ->
                call(mark, new ScriptCanvas(graphics), x + SIGN_RADIUS, y, SIGN_RADIUS));
  }

  private static int densityCamera(Look look) {
    return look.densityCamera().orElse(-1);
  }

  /**
   * A heat map or the cells of a plan.
   *
   * @param figure how the values are shown
   * @param values the values by cell
   */
  record Cells(Record figure, double[] values) {}

  /**
   * Paints a frame of a run within an area.
   *
   * @param cells the cells that are painted instead of the frame's views and targets; null for none
   */
  void paint(Graphics2D graphics, Rectangle2D area, RunFrames run, int index, Cells cells) {
    Graphics2D place = (Graphics2D) graphics.create();
    place.clip(area);
    place.translate(area.getX(), area.getY());
    call(
        "paint",
        new ScriptCanvas(place),
        setup,
        object(picture(area, run, index)),
        cells == null ? null : ReplayJson.of(cells.figure()),
        cells == null ? null : cells.values());
    place.dispose();
  }

  /** Returns the data of a picture for {@code picture.js}. */
  private Map<String, Object> picture(Rectangle2D area, RunFrames run, int index) {
    return Map.of(
        "colours", colors,
        "width", area.getWidth(),
        "height", area.getHeight(),
        "columns", object(run.columns(index)),
        "poses", ReplayJson.of(run.poses(index)),
        "images", run.floor(),
        "opacity", run.look().floorOpacity(),
        "densityCamera", densityCamera(run.look()),
        "tracked", run.look().tracks());
  }

  private Scriptable object(Map<String, ?> properties) {
    return run(
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
    return run(
        context -> {
          Object[] values =
              Arrays.stream(arguments).map(value -> Context.javaToJS(value, scope)).toArray();
          return function.call(context, scope, functions, values);
        });
  }

  private static <T> T run(java.util.function.Function<Context, T> task) {
    try (Context context = Context.enter()) {
      context.setLanguageVersion(Context.VERSION_ES6);
      context.setInterpretedMode(true); // compiling takes longer than even an animation gains
      return task.apply(context);
    }
  }
}

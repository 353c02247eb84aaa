package org.hificamsim.runs.compare;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hificamsim.core.InputException;
import org.hificamsim.runs.RunPlan;

/**
 * One of the equal parts of a comparison.
 *
 * @param number the number of the part, 1 to {@code count}
 * @param count the number of parts
 */
public record Shard(int number, int count) {
  private static final Pattern FORM = Pattern.compile("(\\d{1,7})/(\\d{1,7})");

  /**
   * Reads {@code i/n}.
   *
   * @throws InputException when the text has another form, or i is not in [1, n]
   */
  public static Shard parse(String text) {
    Matcher form = FORM.matcher(text);
    if (form.matches()) {
      Shard shard = new Shard(Integer.parseInt(form.group(1)), Integer.parseInt(form.group(2)));
      if (shard.number >= 1 && shard.number <= shard.count) {
        return shard;
      }
    }
    throw InputException.of(
        "%s is '%s', expected i/n with i from 1 to n, such as 3/8", setting("shard"), text);
  }

  /**
   * Returns the runs of this part. Every run is in one part, and parts differ by at most one run,
   * in each case and in total. The first seed moves on by one from case to case, so that a part
   * gets different seeds of different cases.
   *
   * @param plans the plans of the whole comparison
   */
  public List<RunTask> tasks(List<RunPlan> plans) {
    List<RunTask> tasks = new ArrayList<>();
    long position = 0;
    for (int plan = 0; plan < plans.size(); plan++) {
      int repeats = plans.get(plan).repeats();
      for (int turn = 0; turn < repeats; turn++) {
        if (position++ % count == number - 1) {
          tasks.add(new RunTask(plan, (turn + plan) % repeats));
        }
      }
    }
    return tasks;
  }

  @Override
  public String toString() {
    return number + "/" + count;
  }
}

package org.hificamsim.agents.cooperative;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.policy.BeliefListener;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.SeenPairs;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;
import org.hificamsim.core.scenario.ScenarioReader;

/**
 * Cameras that tell each other what they see, come to a belief of where targets are and go, and
 * divide them among them. They know what they see and receive, where all stand, how long moves
 * take, and the site's map; not where targets are that nobody sees, nor how many there are.
 *
 * <p>In each step: share ({@link SightingReport}), believe ({@link Belief}), look ahead ({@link
 * Plan}), agree ({@link Agreement}).
 */
public final class CooperativeZoomPolicy implements ZoomPolicy {
  private static final String SITE = "site";

  private final Parameters parameters;
  private final Agreement.Rule rule;
  private final boolean each;
  private final String map;
  private final Obstacles other; // in place of the site's own
  private final SeenPairs pairs = new SeenPairs();
  private SightingReport[] reports = {};
  private Agreement agreement;
  private Team team;

  /** Reads the options. */
  public CooperativeZoomPolicy(Options options) {
    this(options, false);
  }

  /**
   * @param each whether each camera has a mind of its own even over a perfect channel
   */
  CooperativeZoomPolicy(Options options, boolean each) {
    this.each = each;
    rule =
        options.choice(
            "agree",
            Agreement.Rule.GREEDY,
            "who chooses what: greedy (in turn), cbba, log-linear, max-sum, none (no messages)");
    parameters = Parameters.from(options);
    map = options.text("map", SITE, "site, none, or a scenario file whose obstacles are the map");
    other = map.equals(SITE) || map.equals("none") ? Obstacles.NONE : read(Path.of(map));
  }

  @Override
  public String name() {
    return "cooperative";
  }

  private static Obstacles read(Path scenario) {
    return new Obstacles(
        ScenarioReader.read(scenario, movement -> true, warning -> {}).obstacles());
  }

  /** The scenario that has the map, where it is not the site's own. */
  @Override
  public List<Path> files() {
    return map.equals(SITE) || map.equals("none") ? List.of() : List.of(Path.of(map));
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    reports = new SightingReport[network.cameras()];
    Arrays.setAll(reports, camera -> new SightingReport(parameters.named()));
    agreement = rule.make(parameters, network, random);
    Obstacles known = map.equals(SITE) ? network.obstacles() : other;
    Site site = new Site(network, known, parameters.cells());
    team = new Team(parameters, site, network, each || !network.channel().isPerfect());
  }

  @Override
  public void decide(NetworkView network, int[] views) {
    look(network);
    team.share(network, reports);
    agreement.agree(network, team);
    for (int camera = 0; camera < views.length; camera++) {
      views[camera] = network.online(camera) ? team.chosen(camera) : views[camera];
    }
  }

  /** What each view would have added to those that all others chose. */
  @Override
  public String estimates(NetworkView network, int camera, double[] estimates, double[] counts) {
    Arrays.fill(counts, Double.NaN);
    Arrays.fill(estimates, Double.NaN);
    Plan plan = team.plan(camera);
    int chosen = plan.view(camera);
    if (chosen != Plan.NONE) {
      System.arraycopy(plan.gains(network, camera), 0, estimates, 0, network.views(camera));
      plan.choose(camera, chosen);
    }
    return "gain";
  }

  @Override
  public boolean believe(NetworkView network, int camera, BeliefListener listener) {
    team.mind(camera).belief().tell(network.step(), listener);
    team.tell(network, listener);
    return true;
  }

  private void look(NetworkView network) {
    for (int camera = 0; camera < reports.length; camera++) {
      reports[camera].begin(network, camera);
    }
    network.findSeen(pairs);
    for (int pair = 0; pair < pairs.count(); pair++) {
      reports[pairs.camera(pair)].add(network, pairs, pair);
    }
  }

  @Override
  public long messages() {
    return team == null ? 0 : team.messages();
  }

  @Override
  public long bits() {
    return team == null ? 0 : team.bits();
  }
}

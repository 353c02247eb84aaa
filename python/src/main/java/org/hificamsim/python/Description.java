package org.hificamsim.python;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.agents.observation.Feature;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.runs.Setting;
import org.hificamsim.worlds.Block;
import org.hificamsim.worlds.WorldSettings;
import org.hificamsim.worlds.Worlds;

/**
 * What Python has to know of worlds to use them.
 *
 * @param cameras their names
 * @param views of each camera
 * @param choices of how many each number of an action is one
 * @param features what the numbers of an observation say
 * @param sections how the shared memory is divided
 * @param bytes how long the memory is
 * @param steps of an episode
 * @param settings the names of the settings of a run
 */
record Description(
    String scenario,
    String detection,
    String objective,
    List<String> cameras,
    List<Integer> views,
    int targets,
    List<Integer> choices,
    List<Feature> features,
    List<Block.Section> sections,
    int bytes,
    int steps,
    List<String> settings) {
  static Description of(Worlds worlds, WorldSettings settings) {
    NetworkView network = worlds.network(0);
    IntStream cameras = IntStream.range(0, network.cameras());
    return new Description(
        settings.scenario().name(),
        settings.detection().name(),
        settings.scenario().objective().text(),
        cameras.mapToObj(network::cameraName).toList(),
        IntStream.range(0, network.cameras()).mapToObj(network::views).toList(),
        network.targets(),
        worlds.choices(),
        settings.layout().features(),
        worlds.block().sections(),
        worlds.block().bytes(),
        settings.steps(),
        Request.SETTINGS.stream().map(Setting::label).toList());
  }

  String json() {
    try {
      return new ObjectMapper().writeValueAsString(this);
    } catch (JsonProcessingException e) {
      throw new IllegalStateException(e);
    }
  }
}

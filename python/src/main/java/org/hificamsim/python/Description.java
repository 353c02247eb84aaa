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
 * The description of worlds that Python needs to use them.
 *
 * @param cameras the names of the cameras
 * @param views the number of views of each camera
 * @param choices the number of choices for each number of an action
 * @param features the meaning of the numbers of an observation
 * @param sections the layout of the shared memory
 * @param bytes the length of the shared memory
 * @param steps the number of steps of an episode
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

package org.hificamsim.presentation.view;

import com.fasterxml.jackson.annotation.JsonSetter;
import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import com.fasterxml.jackson.annotation.Nulls;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.MapperFeature;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.exc.InvalidNullException;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import org.hificamsim.core.InputException;

/** What the page may ask for. */
@JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "command")
@JsonSubTypes({
  @JsonSubTypes.Type(value = Command.Run.class, name = "run"),
  @JsonSubTypes.Type(value = Command.Pause.class, name = "pause"),
  @JsonSubTypes.Type(value = Command.Step.class, name = "step"),
  @JsonSubTypes.Type(value = Command.Speed.class, name = "speed"),
  @JsonSubTypes.Type(value = Command.Restart.class, name = "restart"),
  @JsonSubTypes.Type(value = Command.Drag.class, name = "drag"),
  @JsonSubTypes.Type(value = Command.Turn.class, name = "turn"),
  @JsonSubTypes.Type(value = Command.Add.class, name = "add"),
  @JsonSubTypes.Type(value = Command.Hold.class, name = "hold"),
  @JsonSubTypes.Type(value = Command.Wall.class, name = "wall"),
  @JsonSubTypes.Type(value = Command.Remove.class, name = "remove"),
  @JsonSubTypes.Type(value = Command.Choose.class, name = "choose"),
  @JsonSubTypes.Type(value = Command.Compare.class, name = "compare"),
  @JsonSubTypes.Type(value = Command.Heat.class, name = "heat")
})
public sealed interface Command {
  /**
   * Does it; on the session's thread.
   *
   * @throws InputException when a value is wrong; nothing has changed then
   */
  void obey(LiveSession session);

  /** Step after step, until paused. */
  record Run() implements Command {
    @Override
    public void obey(LiveSession session) {
      session.run();
    }
  }

  /** No more steps. */
  record Pause() implements Command {
    @Override
    public void obey(LiveSession session) {
      session.pause();
    }
  }

  /**
   * Some steps at once.
   *
   * @param steps 1 to 1000
   */
  record Step(int steps) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.steps(steps);
    }
  }

  /**
   * How fast to run.
   *
   * @param perSecond steps per second, 1 to 1000
   */
  record Speed(int perSecond) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.speed(perSecond);
    }
  }

  /**
   * Everything from the start.
   *
   * @param keepCameras whether cameras stay where they were put, and those that were added
   */
  record Restart(long seed, boolean keepCameras) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.renew(run -> run.restart(seed, keepCameras));
    }
  }

  /**
   * A camera is put elsewhere, in all simulations.
   *
   * @param x metres, within the field
   * @param y metres, within the field
   */
  record Drag(int camera, double x, double y) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.change(run -> run.drag(camera, x, y));
    }
  }

  /**
   * A camera looks another way, in all simulations.
   *
   * @param heading degrees, 0 is +y and 90 is +x
   */
  record Turn(int camera, double heading) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.change(run -> run.turn(camera, heading));
    }
  }

  /**
   * A camera more, in all simulations: the targets go on, learning begins again.
   *
   * @param like the camera that has its kind and heading
   * @param x metres, within the field
   * @param y metres, within the field
   */
  record Add(int like, double x, double y) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.renew(run -> run.add(like, x, y));
    }
  }

  /**
   * A camera stays in a view, whatever its policy chooses, in all simulations.
   *
   * @param view -1 to leave it to the policy again
   */
  record Hold(int camera, int view) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.change(run -> run.hold(camera, view));
      session.tellState();
    }
  }

  /** A solid wall more, its ends in metres: learning begins again. */
  record Wall(double x1, double y1, double x2, double y2) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.renew(run -> run.wall(x1, y1, x2, y2));
    }
  }

  /**
   * An obstacle less: learning begins again.
   *
   * @param obstacle its number in the scenario, from 0
   */
  record Remove(int obstacle) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.renew(run -> run.remove(obstacle));
    }
  }

  /**
   * Another detection model, threshold or policy: the targets go on, learning begins again.
   *
   * @param side which simulation, from 0
   */
  record Choose(int side, String detection, Double threshold, String policy) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.choose(side, new LiveChoice(detection, threshold, policy));
    }
  }

  /** A second simulation of the same targets, or no longer. */
  record Compare(boolean on) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.renew(run -> run.compare(on));
    }
  }

  /** A heat map of the steps from now on, in all simulations, or none any more. */
  record Heat(boolean on) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.heat(on);
    }
  }

  /** How commands are read: nothing is left out, added or converted; a threshold may be null. */
  ObjectMapper STRICT =
      JsonMapper.builder()
          .disable(MapperFeature.ALLOW_COERCION_OF_SCALARS)
          .disable(DeserializationFeature.ACCEPT_FLOAT_AS_INT)
          .enable(DeserializationFeature.FAIL_ON_MISSING_CREATOR_PROPERTIES)
          .enable(DeserializationFeature.FAIL_ON_NULL_FOR_PRIMITIVES)
          .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
          .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
          .defaultSetterInfo(JsonSetter.Value.forValueNulls(Nulls.FAIL))
          .withConfigOverride(
              Double.class, type -> type.setSetterInfo(JsonSetter.Value.forValueNulls(Nulls.SET)))
          .build();

  /**
   * Reads a command.
   *
   * @throws InputException when the text is anything else
   */
  static Command read(byte[] json) {
    try {
      Command command = STRICT.readValue(json, Command.class);
      if (command == null) {
        throw new InputException("null, expected a command");
      }
      return command;
    } catch (InvalidNullException e) {
      throw new InputException(e.getPropertyName() + " is null, expected a value", e);
    } catch (JsonProcessingException e) {
      throw new InputException("no command: " + e.getOriginalMessage(), e);
    } catch (IOException e) {
      throw new InputException("no command: " + e.getMessage(), e);
    }
  }
}

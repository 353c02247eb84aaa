package org.hificamsim.presentation.view;

import com.fasterxml.jackson.annotation.JsonSetter;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import com.fasterxml.jackson.annotation.Nulls;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.MapperFeature;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.exc.InvalidNullException;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.jsontype.NamedType;
import java.io.IOException;
import java.util.Arrays;
import java.util.Locale;
import org.hificamsim.core.InputException;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.spec.Zone;

/**
 * A command of the page, whose name in JSON is that of its record in lower case. {@link LiveRun}
 * and {@link LiveSession} describe the values.
 */
@JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "command")
public sealed interface Command {
  /**
   * Executes the command, on the session's thread.
   *
   * @throws InputException if a value is wrong; the session is unchanged then
   */
  void execute(LiveSession session);

  record Run() implements Command {
    @Override
    public void execute(LiveSession session) {
      session.run();
    }
  }

  record Pause() implements Command {
    @Override
    public void execute(LiveSession session) {
      session.pause();
    }
  }

  record Step(int steps) implements Command {
    @Override
    public void execute(LiveSession session) {
      session.runSteps(steps);
    }
  }

  record Speed(int perSecond) implements Command {
    @Override
    public void execute(LiveSession session) {
      session.setSpeed(perSecond);
    }
  }

  record Restart(long seed, boolean keepCameras) implements Command {
    @Override
    public void execute(LiveSession session) {
      session.renew(run -> run.restart(seed, keepCameras));
    }
  }

  record Drag(int camera, double x, double y) implements Command {
    @Override
    public void execute(LiveSession session) {
      session.change(run -> run.drag(camera, x, y));
    }
  }

  record Turn(int camera, double heading) implements Command {
    @Override
    public void execute(LiveSession session) {
      session.change(run -> run.turn(camera, heading));
    }
  }

  record Add(int like, double x, double y) implements Command {
    @Override
    public void execute(LiveSession session) {
      session.renew(run -> run.addCopy(like, x, y));
    }
  }

  record Hold(int camera, int view) implements Command {
    @Override
    public void execute(LiveSession session) {
      session.change(run -> run.hold(camera, view));
    }
  }

  record Draw(DrawnObstacle shape, double x1, double y1, double x2, double y2, Double height)
      implements Command {
    @Override
    public void execute(LiveSession session) {
      Point from = new Point(x1, y1);
      Point to = new Point(x2, y2);
      session.renew(run -> run.edit(scenario -> scenario.addObstacle(shape, from, to, height)));
    }
  }

  /** Adds a rectangular zone between two opposite corners. */
  record AddZone(ZoneDraft zone, double x1, double y1, double x2, double y2) implements Command {
    @Override
    public void execute(LiveSession session) {
      Zone drawn = zone.between(new Point(x1, y1), new Point(x2, y2));
      session.renew(run -> run.addZone(drawn));
    }
  }

  record RemoveZone(int zone) implements Command {
    @Override
    public void execute(LiveSession session) {
      session.renew(run -> run.edit(scenario -> scenario.removeZone(zone)));
    }
  }

  record Mount(Planner.Mount mount) implements Command {
    @Override
    public void execute(LiveSession session) {
      session.renew(run -> run.mount(mount));
    }
  }

  record Scale(double x1, double y1, double x2, double y2, double metres) implements Command {
    @Override
    public void execute(LiveSession session) {
      Point from = new Point(x1, y1);
      Point to = new Point(x2, y2);
      session.renew(run -> run.edit(scenario -> scenario.scale(from, to, metres)));
    }
  }

  record MountHeight(double metres) implements Command {
    @Override
    public void execute(LiveSession session) {
      session.renew(run -> run.edit(scenario -> scenario.hangAt(metres)));
    }
  }

  record Plan(Planner.Goal goal, double amount, boolean keep, boolean ceiling) implements Command {
    @Override
    public void execute(LiveSession session) {
      session.plan(new Planner.Request(goal, amount, keep, ceiling));
    }
  }

  record StopPlan() implements Command {
    @Override
    public void execute(LiveSession session) {
      session.stopPlan();
    }
  }

  record Remove(int obstacle) implements Command {
    @Override
    public void execute(LiveSession session) {
      session.renew(run -> run.edit(scenario -> scenario.removeObstacle(obstacle)));
    }
  }

  record RemoveCamera(int camera) implements Command {
    @Override
    public void execute(LiveSession session) {
      session.renew(run -> run.edit(scenario -> scenario.removeCamera(camera)));
    }
  }

  record RemoveTarget(int target) implements Command {
    @Override
    public void execute(LiveSession session) {
      session.renew(run -> run.edit(scenario -> scenario.removeTarget(target)));
    }
  }

  record Suggest(int camera) implements Command {
    @Override
    public void execute(LiveSession session) {
      session.renew(run -> run.suggest(camera));
    }
  }

  record Undo() implements Command {
    @Override
    public void execute(LiveSession session) {
      session.renew(LiveRun::undo);
    }
  }

  record Redo() implements Command {
    @Override
    public void execute(LiveSession session) {
      session.renew(LiveRun::redo);
    }
  }

  record Choose(int side, String detection, Double threshold, String policy) implements Command {
    @Override
    public void execute(LiveSession session) {
      session.choose(side, new LiveChoice(detection, threshold, policy));
    }
  }

  record Compare(boolean on) implements Command {
    @Override
    public void execute(LiveSession session) {
      session.renew(run -> run.compare(on));
    }
  }

  record Heat(boolean on) implements Command {
    @Override
    public void execute(LiveSession session) {
      session.change(run -> run.recordHeat(on));
    }
  }

  /**
   * The mapper that rejects missing, unknown and converted values, and nulls except that of a
   * threshold.
   */
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
          .registerSubtypes(
              Arrays.stream(Command.class.getPermittedSubclasses())
                  .map(type -> new NamedType(type, type.getSimpleName().toLowerCase(Locale.ROOT)))
                  .toArray(NamedType[]::new))
          .build();

  /**
   * Reads a command.
   *
   * @throws InputException if the text is not a valid command
   */
  static Command read(byte[] json) {
    try {
      Command command = STRICT.readValue(json, Command.class);
      if (command == null) {
        throw new InputException("the command is null, expected an object");
      }
      return command;
    } catch (InvalidNullException e) {
      throw new InputException(e.getPropertyName() + " is null, expected a value", e);
    } catch (JsonProcessingException e) {
      throw new InputException("the command cannot be read: " + e.getOriginalMessage(), e);
    } catch (IOException e) {
      throw new InputException("the command cannot be read: " + e.getMessage(), e);
    }
  }
}

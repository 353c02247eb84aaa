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

/**
 * What the page may ask for, each by the name of its record in lower case. {@link LiveRun} and
 * {@link LiveSession} say what the values are.
 */
@JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "command")
public sealed interface Command {
  /**
   * Does it; on the session's thread.
   *
   * @throws InputException when a value is wrong; nothing has changed then
   */
  void obey(LiveSession session);

  record Run() implements Command {
    @Override
    public void obey(LiveSession session) {
      session.run();
    }
  }

  record Pause() implements Command {
    @Override
    public void obey(LiveSession session) {
      session.pause();
    }
  }

  record Step(int steps) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.steps(steps);
    }
  }

  record Speed(int perSecond) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.speed(perSecond);
    }
  }

  record Restart(long seed, boolean keepCameras) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.renew(run -> run.restart(seed, keepCameras));
    }
  }

  record Drag(int camera, double x, double y) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.change(run -> run.drag(camera, x, y));
    }
  }

  record Turn(int camera, double heading) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.change(run -> run.turn(camera, heading));
    }
  }

  record Add(int like, double x, double y) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.renew(run -> run.add(like, x, y));
    }
  }

  record Hold(int camera, int view) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.change(run -> run.hold(camera, view));
    }
  }

  record Wall(double x1, double y1, double x2, double y2) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.renew(run -> run.edit(now -> now.wall(x1, y1, x2, y2)));
    }
  }

  record Remove(int obstacle) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.renew(run -> run.edit(now -> now.removeObstacle(obstacle)));
    }
  }

  record RemoveCamera(int camera) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.renew(run -> run.edit(now -> now.removeCamera(camera)));
    }
  }

  record RemoveTarget(int target) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.renew(run -> run.edit(now -> now.removeTarget(target)));
    }
  }

  record Suggest(int camera) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.renew(run -> run.suggest(camera));
    }
  }

  record Undo() implements Command {
    @Override
    public void obey(LiveSession session) {
      session.renew(LiveRun::undo);
    }
  }

  record Redo() implements Command {
    @Override
    public void obey(LiveSession session) {
      session.renew(LiveRun::redo);
    }
  }

  record Choose(int side, String detection, Double threshold, String policy) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.choose(side, new LiveChoice(detection, threshold, policy));
    }
  }

  record Compare(boolean on) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.renew(run -> run.compare(on));
    }
  }

  record Heat(boolean on) implements Command {
    @Override
    public void obey(LiveSession session) {
      session.change(run -> run.heat(on));
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
          .registerSubtypes(
              Arrays.stream(Command.class.getPermittedSubclasses())
                  .map(type -> new NamedType(type, type.getSimpleName().toLowerCase(Locale.ROOT)))
                  .toArray(NamedType[]::new))
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

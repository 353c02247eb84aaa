package org.hificamsim.core.channel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ChannelTest {
  private static final int STEPS = 200_000;

  /** Cameras on a line, ten metres apart. */
  private static final class Line implements Stations {
    private final boolean[] online;
    private long step;
    private int revision;

    Line(int cameras) {
      online = new boolean[cameras];
      Arrays.fill(online, true);
    }

    void fail(int camera) {
      online[camera] = false;
      revision++;
    }

    @Override
    public long step() {
      return step;
    }

    @Override
    public int revision() {
      return revision;
    }

    @Override
    public int cameras() {
      return online.length;
    }

    @Override
    public boolean online(int camera) {
      return online[camera];
    }

    @Override
    public double cameraX(int camera) {
      return 10.0 * camera;
    }

    @Override
    public double cameraY(int camera) {
      return 0;
    }
  }

  private static Channel channel(String model, Line line, long seed) {
    return new Channel(ChannelModel.parse(model), line, seed);
  }

  /** The delays of messages from camera 0 to 1, one per step. */
  private static int[] delays(String model) {
    Line line = new Line(2);
    Channel channel = channel(model, line, 7);
    return IntStream.range(0, STEPS).map(step -> delay(line, channel, step, 0, 1)).toArray();
  }

  private static int delay(Line line, Channel channel, int step, int from, int to) {
    line.step = step;
    assertTrue(channel.send(from, 8));
    return channel.delay(from, to);
  }

  private static double lost(int[] delays) {
    return IntStream.of(delays).filter(delay -> delay == Channel.LOST).count() / (double) STEPS;
  }

  /** Returns four standard errors of a share of independent draws. */
  private static double margin(double share) {
    return 4 * Math.sqrt(share * (1 - share) / STEPS);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.2, 0.5, 1})
  void losesGivenShareOfMessages(double loss) {
    assertEquals(loss, lost(delays("loss=" + loss)), margin(loss) + 1e-12);
  }

  @Test
  void lossesAreIndependentWithoutBursts() {
    int[] delays = delays("loss=0.3");
    long lostPairs =
        IntStream.range(1, STEPS)
            .filter(i -> delays[i] == Channel.LOST && delays[i - 1] == Channel.LOST)
            .count();
    assertEquals(0.09, lostPairs / (STEPS - 1.0), margin(0.09));
  }

  /** The mean of n geometric lengths with mean L has a standard error of about L / sqrt(n). */
  @ParameterizedTest
  @CsvSource({"0.2, 5", "0.1, 20", "0.5, 2", "0.6, 1.6"})
  void burstsHaveGivenLengthAndKeepMeanLoss(double loss, double burst) {
    int[] delays = delays("loss=%s,burst=%s".formatted(loss, burst));
    List<Integer> lengths = new ArrayList<>();
    for (int i = 1, length = 0; i < STEPS; i++) {
      length = delays[i] == Channel.LOST ? length + 1 : 0;
      if (length > 0 && (i + 1 == STEPS || delays[i + 1] != Channel.LOST)) {
        lengths.add(length);
      }
    }
    double mean = lengths.stream().mapToInt(Integer::intValue).average().orElseThrow();
    assertEquals(burst, mean, 4 * burst / Math.sqrt(lengths.size()));
    assertEquals(loss, lost(delays), margin(loss) * 2 * Math.sqrt(burst));
  }

  @Test
  void bothStatesMayLosePartOfTheMessages() {
    double lost = lost(delays("loss=0.2,burst=5,h=0.4,k=0.95"));
    assertEquals(0.2, lost, 4 * margin(0.2));
  }

  @Test
  void computesStateOfLinkWithoutEarlierSteps() {
    int[] inOrder = delays("loss=0.3,burst=50");
    Line line = new Line(2);
    Channel late = channel("loss=0.3,burst=50", line, 7);
    for (int step = STEPS - 1; step > STEPS - 1000; step--) {
      line.step = step;
      late.send(0, 8);
      assertEquals(inOrder[step], late.delay(0, 1));
    }
  }

  @Test
  void constantDelayIsExact() {
    assertTrue(IntStream.of(delays("delay=3")).allMatch(delay -> delay == 3));
  }

  @Test
  void uniformDelaysAreEquallyFrequent() {
    int[] delays = delays("delay=1..4");
    for (int steps = 1; steps <= 4; steps++) {
      int expectedDelay = steps;
      double share = IntStream.of(delays).filter(d -> d == expectedDelay).count() / (double) STEPS;
      assertEquals(0.25, share, margin(0.25));
    }
  }

  @Test
  void roundsExponentialDelayToSteps() {
    int[] delays = delays("delay=exponential:2");
    double none = 1 - Math.exp(-0.25);
    double share = IntStream.of(delays).filter(d -> d == 0).count() / (double) STEPS;
    assertEquals(none, share, margin(none));
    assertEquals(2, IntStream.of(delays).average().orElseThrow(), 0.05);
  }

  @Test
  void linkIsIndependentOfOtherMessages() {
    Line line = new Line(3);
    Channel alone = channel("loss=0.4,delay=0..9", line, 1);
    Channel busy = channel("loss=0.4,delay=0..9", line, 1);
    for (int step = 0; step < 100; step++) {
      int expected = delay(line, alone, step, 1, 2);
      delay(line, busy, step, step % 3 == 1 ? 0 : 2, 1);
      assertEquals(expected, delay(line, busy, step, 1, 2));
    }
  }

  @Test
  void drawsDifferPerSeedLinkAndMessage() {
    Line line = new Line(3);
    Channel channel = channel("delay=0..9999", line, 1);
    int first = delay(line, channel, 5, 0, 1);
    assertEquals(first, channel.delay(0, 1));
    assertFalse(first == channel.delay(0, 2));
    assertFalse(first == delay(line, channel, 5, 0, 1));
    assertFalse(first == delay(line, channel("delay=0..9999", line, 2), 5, 0, 1));
  }

  @Test
  void routesAddDelaysAndAvoidFailedCameras() {
    Line line = new Line(6);
    Channel channel = channel("delay=2,range=20", line, 0);
    assertEquals(2, delay(line, channel, 0, 0, 2));
    assertEquals(6, delay(line, channel, 0, 0, 5));
    line.fail(2);
    assertEquals(6, delay(line, channel, 1, 0, 5));
    line.fail(3);
    assertEquals(Channel.LOST, delay(line, channel, 2, 0, 5));
    assertEquals(2, delay(line, channel, 2, 0, 1));
  }

  @Test
  void losesMessagesAtEachHop() {
    Line line = new Line(4);
    Channel channel = channel("loss=0.1,range=10", line, 0);
    long arrived =
        IntStream.range(0, STEPS)
            .filter(step -> delay(line, channel, step, 0, 3) != Channel.LOST)
            .count();
    double expected = 0.9 * 0.9 * 0.9;
    assertEquals(expected, arrived / (double) STEPS, margin(expected));
  }

  @Test
  void drawsEachHopOnceForAllReceivers() {
    Line line = new Line(3);
    Channel channel = channel("loss=0.5,range=10", line, 0);
    for (int step = 0; step < 1000; step++) {
      int far = delay(line, channel, step, 0, 2);
      assertTrue(far == Channel.LOST || channel.delay(0, 1) == 0);
    }
  }

  @Test
  void queuesMessagesAndDropsThemIfFull() {
    Line line = new Line(2);
    Channel channel = channel("bandwidth=10,queue=2", line, 0);
    assertEquals(0, delay(line, channel, 0, 0, 1)); // 8 bits of this step's 10
    assertEquals(1, delay(line, channel, 0, 0, 1)); // 16
    assertEquals(2, delay(line, channel, 0, 0, 1)); // 24
    assertFalse(channel.send(0, 8)); // 32 exceed 10 now and 20 waiting
    assertEquals(1, channel.dropped());
    assertEquals(2, delay(line, channel, 1, 0, 1)); // 14 wait, 8 more
    assertEquals(0, delay(line, channel, 9, 0, 1));
  }

  @Test
  void deliversByArrivalThenBySending() {
    Line line = new Line(3);
    Post<String> post = new Post<>(line, channel("delay=1", line, 0));
    List<String> received = new ArrayList<>();
    Post.Receiver<String> receiver =
        (from, to, sent, text) -> received.add(from + ">" + to + "@" + sent + text);
    post.broadcast(2, 8, "a");
    post.send(0, 1, 8, "b");
    post.deliver(receiver);
    assertEquals(List.of(), received);
    line.step = 1;
    line.fail(0);
    post.deliver(receiver);
    assertEquals(List.of("2>1@0a", "0>1@0b"), received);
  }

  @Test
  void deliversInstantAnswersInTheSameStep() {
    Line line = new Line(2);
    Post<String> post = new Post<>(line, channel("perfect", line, 0));
    List<String> received = new ArrayList<>();
    post.send(0, 1, 8, "ask");
    post.deliver(
        (from, to, sent, text) -> {
          received.add(text);
          if (text.equals("ask")) {
            post.send(to, from, 8, "answer");
          }
        });
    assertEquals(List.of("ask", "answer"), received);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "perfect | perfect",
        "loss=0 | perfect",
        "loss=0.20,delay=2 | loss=0.2,delay=2",
        "delay=1..5,range=30 | delay=1..5,range=30",
        "bandwidth=1000,queue=10 | bandwidth=1000",
        "loss=0.2,burst=5,h=0.1,k=1 | loss=0.2,burst=5,h=0.1",
      })
  void textOmitsDefaults(String text, String written) {
    ChannelModel model = ChannelModel.parse(text);
    assertEquals(written, model.text());
    assertEquals(model, ChannelModel.parse(written));
    assertEquals(written.equals("perfect"), model.isPerfect());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "los=0.2",
        "loss=2",
        "loss=NaN",
        "loss=0.2,burst=0.5",
        "loss=0.2,h=0.1",
        "loss=1,burst=5",
        "loss=0.99,burst=1",
        "loss=0.1,burst=5,k=0.8",
        "loss=0.5,burst=1",
        "delay=-1",
        "delay=5..2",
        "delay=10001",
        "delay=exponential:-1",
        "range=-3",
        "bandwidth=1.5",
        "queue=0",
      })
  void rejectsInvalidModelsInOneLine(String text) {
    InputException error = assertThrows(InputException.class, () -> ChannelModel.parse(text), text);
    assertTrue(error.getMessage().matches("channel: .*, expected .*"), error.getMessage());
  }
}

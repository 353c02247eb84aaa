package org.hificamsim.network.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests the order and the counts of delivered messages. */
class MessageQueueTest {
  private final MessageQueue queue = new MessageQueue(4, 8);

  @Test
  void deliversInOrderSentAndCountsReceiversByKind() {
    for (int i = 0; i < 200; i++) {
      queue.send(i % 2 == 0 ? MessageKind.START_SEARCH : MessageKind.FOUND, i, i + 1, 7, i / 2.0);
    }
    queue.send(MessageKind.START_TRACKING, 1, 2, 3, 0.5);
    queue.send(MessageKind.START_SEARCH, 1, MessageQueue.NEIGHBOURS, 3, 0);
    List<String> delivered = new ArrayList<>();
    queue.deliver(
        (kind, from, to, target, value) -> {
          delivered.add(kind + " " + from + " " + to + " " + target + " " + value);
          return to == MessageQueue.NEIGHBOURS ? 5 : 1;
        });
    assertEquals(202, delivered.size());
    assertEquals("START_SEARCH 0 1 7 0.0", delivered.get(0));
    assertEquals("FOUND 199 200 7 99.5", delivered.get(199));
    assertEquals("START_TRACKING 1 2 3 0.5", delivered.get(200));
    assertEquals(105, queue.startSearches());
    assertEquals(1, queue.startTrackings());
    queue.deliver(
        (kind, from, to, target, value) -> {
          throw new AssertionError("delivered again");
        });
    queue.resetCounts();
    assertEquals(0, queue.startSearches());
  }

  @Test
  void deliversAnswersSentDuringDelivery() {
    List<MessageKind> delivered = new ArrayList<>();
    queue.send(MessageKind.START_SEARCH, 0, 1, 0, 0);
    queue.deliver(
        (kind, from, to, target, value) -> {
          delivered.add(kind);
          if (kind == MessageKind.START_SEARCH) {
            queue.send(MessageKind.FOUND, to, from, target, 1);
          }
          return 1;
        });
    assertEquals(List.of(MessageKind.START_SEARCH, MessageKind.FOUND), delivered);
  }
}

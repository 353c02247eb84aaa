package org.hificamsim.python;

import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.io.RandomAccessFile;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import org.hificamsim.core.InputException;
import org.hificamsim.worlds.EpisodeOverException;

/**
 * Serves a session over standard input and output, with a memory-mapped file shared with the
 * client; it ends when its input ends.
 *
 * <p>Every message is a letter, the length of the content as four bytes, big-endian, and the
 * content. Requests: o opens worlds (settings as JSON), s steps, r resets (world or -1, 4 bytes;
 * seed, 8 bytes; 1 to use the seed, else 0), t writes states, n asks for the seed of the episode, p
 * for a picture (world and width, 4 bytes each), v saves, w restores (what v returned). Replies: k
 * for success, with the result; i for wrong input, n where an episode is over, and e for any other
 * failure, each with a message.
 */
public final class Server {
  private final DataInputStream in;
  private final DataOutputStream out;
  private final String file;
  private final long maxBytes;
  private Session session;

  private Server(InputStream in, OutputStream out, String file, long maxBytes) {
    this.in = new DataInputStream(in);
    this.out = new DataOutputStream(new BufferedOutputStream(out));
    this.file = file;
    this.maxBytes = maxBytes;
  }

  /**
   * Serves one session, and exits when the process that started it exits.
   *
   * @param args the existing file to map, its greatest length in bytes, and the id of that process
   */
  public static void main(String[] args) throws IOException {
    OutputStream out = new FileOutputStream(FileDescriptor.out);
    // users' extensions may print, which must not disturb the protocol
    System.setOut(new PrintStream(System.err, true, StandardCharsets.UTF_8));
    Thread watch = new Thread(() -> endWith(Long.parseLong(args[2])), "end of Python");
    watch.setDaemon(true);
    watch.start();
    long maxBytes = Long.parseLong(args[1]);
    new Server(new FileInputStream(FileDescriptor.in), out, args[0], maxBytes).serve();
    System.exit(0);
  }

  /**
   * Ends this process when Python has ended. It checks twice a second, since a session does not
   * read its input while it creates worlds.
   */
  private static void endWith(long python) {
    try {
      while (ProcessHandle.current()
          .parent()
          .filter(parent -> parent.pid() == python)
          .isPresent()) {
        Thread.sleep(500);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    Runtime.getRuntime().halt(1);
  }

  private void serve() throws IOException {
    try {
      while (true) {
        answer(in.readByte(), in.readNBytes(in.readInt()));
      }
    } catch (EOFException e) {
      // the client has ended
    }
  }

  @SuppressWarnings("CatchAndPrintStackTrace") // Python shows standard error
  private void answer(byte letter, byte[] message) throws IOException {
    try {
      reply('k', answerTo((char) letter, ByteBuffer.wrap(message)));
    } catch (InputException e) {
      reply('i', bytes(Session.message(e)));
    } catch (EpisodeOverException e) {
      reply('n', bytes(e.getMessage()));
    } catch (RuntimeException | Error e) {
      e.printStackTrace();
      reply('e', bytes(e.toString()));
    }
  }

  private void reply(char letter, byte[] message) throws IOException {
    out.writeByte(letter);
    out.writeInt(message.length);
    out.write(message);
    out.flush();
  }

  private byte[] answerTo(char letter, ByteBuffer message) {
    switch (letter) {
      case 'o' -> {
        session = Session.open(StandardCharsets.UTF_8.decode(message).toString(), this::map);
        return bytes(session.description());
      }
      case 's' -> session.step();
      case 'r' -> session.reset(message.getInt(), message.getLong(), message.get() != 0);
      case 't' -> session.state();
      case 'v' -> {
        return session.save();
      }
      case 'w' -> session.restore(remaining(message));
      case 'n' -> {
        return ByteBuffer.allocate(Long.BYTES).putLong(session.seed()).array();
      }
      case 'p' -> {
        return session.picture(message.getInt(), message.getInt());
      }
      default -> throw new IllegalArgumentException("no message begins with '" + letter + "'");
    }
    return new byte[0];
  }

  private static byte[] remaining(ByteBuffer message) {
    byte[] bytes = new byte[message.remaining()];
    message.get(bytes);
    return bytes;
  }

  private ByteBuffer map(int bytes) {
    if (bytes > maxBytes) {
      throw InputException.of(
          "the worlds take %s MB of shared memory, expected at most the %s MB that are"
              + " free: fewer worlds, or backend 'jvm'",
          (bytes >> 20) + 1, maxBytes >> 20);
    }
    try (RandomAccessFile shared = new RandomAccessFile(file, "rw")) {
      shared.setLength(bytes);
      return shared.getChannel().map(FileChannel.MapMode.READ_WRITE, 0, bytes);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }
}

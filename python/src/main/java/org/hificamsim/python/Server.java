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

/**
 * A session over standard input and output, its memory a file that both sides map; it ends with its
 * input.
 *
 * <p>Every message is a letter and the length of what follows, four bytes, the highest first. In: o
 * settings as JSON, s step, r reset (world or -1, 4 bytes; seed, 8 bytes; 1 where it counts, else
 * 0), t state, n seed of the episode, p picture (world and width, 4 bytes each). Out: k for done,
 * with what was asked for; i for input that is wrong, e for anything else, each with a line that
 * says what.
 */
public final class Server {
  private final DataInputStream in;
  private final DataOutputStream out;
  private final String file;
  private final long room;
  private Session session;

  private Server(InputStream in, OutputStream out, String file, long room) {
    this.in = new DataInputStream(in);
    this.out = new DataOutputStream(new BufferedOutputStream(out));
    this.file = file;
    this.room = room;
  }

  /**
   * Serves one session, and ends with the process that started it, whatever it is at. The arguments
   * are the file to be mapped, which exists, how many bytes there are for it, and that process.
   */
  public static void main(String[] args) throws IOException {
    OutputStream out = new FileOutputStream(FileDescriptor.out);
    System.setOut(
        new PrintStream(System.err, true, StandardCharsets.UTF_8)); // a user's part may print
    Thread watch = new Thread(() -> endWith(Long.parseLong(args[2])), "end of Python");
    watch.setDaemon(true);
    watch.start();
    long room = Long.parseLong(args[1]);
    new Server(new FileInputStream(FileDescriptor.in), out, args[0], room).serve();
    System.exit(0);
  }

  /** Looks twice a second, since a session that builds its worlds does not see its input end. */
  private static void endWith(long python) {
    try {
      while (ProcessHandle.current().parent().filter(one -> one.pid() == python).isPresent()) {
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
      // nobody asks any more
    }
  }

  @SuppressWarnings("CatchAndPrintStackTrace") // the trace goes where Python shows it
  private void answer(byte letter, byte[] message) throws IOException {
    try {
      reply('k', answerTo((char) letter, ByteBuffer.wrap(message)));
    } catch (InputException e) {
      reply('i', bytes(Session.message(e)));
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

  private ByteBuffer map(int bytes) {
    if (bytes > room) {
      throw InputException.of(
          "the worlds take %s MB of shared memory, expected at most the %s MB that are"
              + " free: fewer worlds, or backend 'jvm'",
          (bytes >> 20) + 1, room >> 20);
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

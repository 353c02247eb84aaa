import java.io.IOException;
import java.io.OutputStream;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Collections;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import java.util.zip.ZipOutputStream;
import jdk.internal.org.objectweb.asm.ClassReader;
import jdk.internal.org.objectweb.asm.ClassVisitor;
import jdk.internal.org.objectweb.asm.ClassWriter;
import jdk.internal.org.objectweb.asm.Opcodes;

/**
 * Rewrites the classes of a jar in Java 8's format where theirs is that of Java 5: JDK 17's
 * archives of classes, for quick starting, hold none that are older than Java 6's. What they do
 * stays. The jar is replaced when every class has been verified. Needs JDK 17's own copy of ASM:
 *
 * <pre>
 * java --add-exports java.base/jdk.internal.org.objectweb.asm=ALL-UNNAMED NewerClasses.java JAR
 * </pre>
 */
final class NewerClasses {
  private static final int OLDEST = Opcodes.V1_6;
  private static final int MAJOR = 7; // the byte of a class file that has its version

  private NewerClasses() {}

  public static void main(String[] args) throws Exception {
    Path jar = Path.of(args[0]);
    Path newer = Path.of(args[0] + ".new");
    try {
      write(jar, newer);
      verify(newer);
      Files.move(newer, jar, StandardCopyOption.ATOMIC_MOVE);
    } finally {
      Files.deleteIfExists(newer);
    }
  }

  private static void write(Path jar, Path newer) throws IOException {
    try (ZipFile in = new ZipFile(jar.toFile());
        URLClassLoader loader = loader(jar);
        OutputStream file = Files.newOutputStream(newer);
        ZipOutputStream out = new ZipOutputStream(file)) {
      for (ZipEntry entry : Collections.list(in.entries())) {
        byte[] content = in.getInputStream(entry).readAllBytes();
        boolean old = entry.getName().endsWith(".class") && content[MAJOR] < OLDEST;
        ZipEntry copy = new ZipEntry(entry.getName());
        copy.setTime(entry.getTime());
        out.putNextEntry(copy);
        out.write(old ? newer(content, loader) : content);
      }
    }
  }

  private static URLClassLoader loader(Path jar) throws IOException {
    return new URLClassLoader(
        new URL[] {jar.toUri().toURL()}, ClassLoader.getPlatformClassLoader()); // the jar's alone
  }

  private static byte[] newer(byte[] content, ClassLoader loader) {
    ClassWriter writer =
        new ClassWriter(ClassWriter.COMPUTE_FRAMES) {
          @Override
          protected ClassLoader getClassLoader() {
            return loader;
          }
        };
    ClassVisitor renewed =
        new ClassVisitor(Opcodes.ASM8, writer) {
          @Override
          public void visit(
              int version, int access, String name, String of, String parent, String[] interfaces) {
            super.visit(Opcodes.V1_8, access, name, of, parent, interfaces);
          }
        };
    new ClassReader(content).accept(renewed, ClassReader.SKIP_FRAMES);
    return writer.toByteArray();
  }

  /** Initialises all classes, which verifies them: a VerifyError ends this program. */
  private static void verify(Path jar) throws Exception {
    try (ZipFile in = new ZipFile(jar.toFile());
        URLClassLoader loader = loader(jar)) {
      for (ZipEntry entry : Collections.list(in.entries())) {
        String name = entry.getName();
        if (name.endsWith(".class")
            && !name.startsWith("META-INF/")
            && !name.startsWith("module-")) {
          String of = name.substring(0, name.length() - ".class".length()).replace('/', '.');
          Class.forName(of, true, loader);
        }
      }
    }
  }
}

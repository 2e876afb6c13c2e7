package badlog.benchmarks.robot;

import badlog.lib.BadLog;
import badlog.lib.DataInferMode;
import badlog.lib.Publisher;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;

/** Measures a robot's loop: ten numbers published, all topics updated, a row written and flushed. */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
public class LoopBenchmark {
    /** Creates a file for each iteration. It is on a memory disk if there is one, so that the log is measured, not the disk. */
    abstract static class Logging {
        final Signals signals = new Signals();
        private Path file;

        abstract void start(Path file) throws IOException;

        abstract void stop() throws IOException;

        @Setup(Level.Iteration)
        public void open() throws IOException {
            Path memory = Path.of("/dev/shm");
            file = Files.isWritable(memory) ? Files.createTempFile(memory, "badlog", ".bag")
                : Files.createTempFile("badlog", ".bag");
            start(file);
        }

        @TearDown(Level.Iteration)
        public void close() throws IOException {
            stop();
            Files.delete(file);
        }
    }

    /** badlog's logger; subclasses create the topics. */
    abstract static class Ours extends Logging {
        private final String[] names = new String[Signals.PUBLISHED];
        BadLog log;

        abstract void createQueried(int number);

        @Override
        void start(Path file) {
            log = BadLog.init(file.toString());
            for (int i = 0; i < Signals.QUERIED; i++) {
                createQueried(i);
            }
            for (int i = 0; i < Signals.PUBLISHED; i++) {
                names[i] = "Published/" + i;
                createPublished(i, names[i]);
            }
            log.finishInitialization();
        }

        void createPublished(int number, String name) {
            BadLog.createTopicSubscriber(name, "V", DataInferMode.DEFAULT);
        }

        void publish(int number, double value) {
            BadLog.publish(names[number], value);
        }

        @Override
        void stop() {
            log.close();
        }
    }

    /** Numbers from primitive suppliers and handles. */
    @State(Scope.Benchmark)
    public static class Primitive extends Ours {
        private final Publisher[] publishers = new Publisher[Signals.PUBLISHED];

        @Override
        void createQueried(int number) {
            BadLog.createTopicDouble("Queried/" + number, "V", () -> signals.signal(number));
        }

        @Override
        void createPublished(int number, String name) {
            publishers[number] = BadLog.createPublisher(name, "V", DataInferMode.DEFAULT);
        }

        @Override
        void publish(int number, double value) {
            publishers[number].publish(value);
        }
    }

    /** The functions of the original badLog. */
    @State(Scope.Benchmark)
    public static class DropIn extends Ours {
        @Override
        void createQueried(int number) {
            BadLog.createTopic("Queried/" + number, "V", () -> signals.signal(number));
        }
    }

    /** The implementation of the original badLog. */
    @State(Scope.Benchmark)
    public static class Straightforward extends Logging {
        private final String[] names = new String[Signals.PUBLISHED];
        private StraightforwardLog log;

        @Override
        void start(Path file) throws IOException {
            log = new StraightforwardLog(file);
            for (int i = 0; i < Signals.QUERIED; i++) {
                int number = i;
                log.query("Queried/" + i, () -> signals.signal(number));
            }
            for (int i = 0; i < Signals.PUBLISHED; i++) {
                names[i] = "Published/" + i;
                log.subscribe(names[i]);
            }
            log.start();
        }

        @Override
        void stop() throws IOException {
            log.close();
        }
    }

    @Benchmark
    public void primitive(Primitive robot) {
        loop(robot);
    }

    @Benchmark
    public void dropIn(DropIn robot) {
        loop(robot);
    }

    @Benchmark
    public void straightforward(Straightforward robot) {
        robot.signals.next();
        for (int i = 0; i < Signals.PUBLISHED; i++) {
            robot.log.publish(robot.names[i], robot.signals.signal(Signals.QUERIED + i));
        }
        robot.log.update();
        robot.log.log();
    }

    private static void loop(Ours robot) {
        robot.signals.next();
        for (int i = 0; i < Signals.PUBLISHED; i++) {
            robot.publish(i, robot.signals.signal(Signals.QUERIED + i));
        }
        robot.log.updateTopics();
        robot.log.log();
    }
}

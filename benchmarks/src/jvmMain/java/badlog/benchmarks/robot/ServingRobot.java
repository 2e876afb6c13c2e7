package badlog.benchmarks.robot;

import badlog.lib.BadLog;
import badlog.lib.DataInferMode;
import badlog.lib.Publisher;
import badlog.web.LogServer;
import badlog.web.LogServerOptions;
import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.util.List;
import java.util.concurrent.locks.LockSupport;

/**
 * A robot that logs 50 numbers every 20 ms and serves the folder of its logs. Each loop has 2 ms of other work. For each line on standard
 * input it runs some loops, and prints the time from each loop's due time to its end, in ns. Arguments: the folder, the port.
 */
final class ServingRobot {
    private static final int LOOPS = 500;
    private static final long PERIOD_NANOS = 20_000_000;
    private static final long WORK_NANOS = 2_000_000;

    private final Signals signals = new Signals();
    private final Publisher[] publishers = new Publisher[Signals.PUBLISHED];
    private final BadLog log;
    private double worked;

    private ServingRobot(File folder) {
        log = BadLog.init(new File(folder, "running.bag").getPath());
        for (int i = 0; i < Signals.QUERIED; i++) {
            int number = i;
            BadLog.createTopicDouble("Queried/" + i, "V", () -> signals.signal(number));
        }
        for (int i = 0; i < Signals.PUBLISHED; i++) {
            publishers[i] = BadLog.createPublisher("Published/" + i, "V", DataInferMode.DEFAULT);
        }
        log.finishInitialization();
    }

    public static void main(String[] args) throws IOException {
        File folder = new File(args[0]);
        ServingRobot robot = new ServingRobot(folder);
        LogServerOptions options = new LogServerOptions();
        options.setFolders(List.of(folder));
        LogServer.start(Integer.parseInt(args[1]), options);
        int rounds = calibrated(robot);
        BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
        long[] taken = new long[LOOPS];
        System.out.println("ready");
        while (in.readLine() != null) {
            robot.run(taken, rounds);
            StringBuilder line = new StringBuilder();
            for (long nanos : taken) {
                line.append(nanos).append(' ');
            }
            System.out.println(line.append(robot.worked > 0 ? "" : "0"));
        }
    }

    /** Returns the number of rounds of work that take 2 ms when compiled. The work is constant, however often it is interrupted. */
    private static int calibrated(ServingRobot robot) {
        int rounds = 1000;
        for (int i = 0; i < 500; i++) {
            long began = System.nanoTime();
            robot.work(rounds);
            long nanos = Math.max(1, System.nanoTime() - began);
            if (i % 50 == 49) {
                rounds = (int) Math.min(10_000_000, rounds * WORK_NANOS / nanos + 1);
            }
        }
        return rounds;
    }

    private void run(long[] taken, int rounds) {
        long due = System.nanoTime() + PERIOD_NANOS;
        for (int i = 0; i < taken.length; i++) {
            while (System.nanoTime() < due) {
                LockSupport.parkNanos(due - System.nanoTime());
            }
            signals.next();
            work(rounds);
            for (int j = 0; j < publishers.length; j++) {
                publishers[j].publish(signals.signal(Signals.QUERIED + j));
            }
            log.updateTopics();
            log.log();
            taken[i] = System.nanoTime() - due;
            due = Math.max(due + PERIOD_NANOS, System.nanoTime());
        }
    }

    private void work(int rounds) {
        double sum = worked;
        for (int i = 0; i < rounds; i++) {
            sum += Math.sqrt(i + sum % 3);
        }
        worked = sum % 1000 + 1;
    }
}

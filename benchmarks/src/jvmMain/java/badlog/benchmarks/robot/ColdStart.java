package badlog.benchmarks.robot;

import badlog.lib.BadLog;
import badlog.lib.DataInferMode;
import java.util.function.Supplier;

/**
 * Prints the time from {@code init} to the first row, in µs, in a new JVM without classes of badlog. The program's own first lambda and its
 * names are created before that, because any logger would need them.
 */
final class ColdStart {
    private ColdStart() {
    }

    public static void main(String[] args) {
        double[] value = {1.5};
        Supplier<Double> supplier = () -> value[0]++;
        String[] names = new String[Signals.QUERIED + Signals.PUBLISHED];
        for (int i = 0; i < names.length; i++) {
            names[i] = "Topic/" + i;
        }

        long began = System.nanoTime();
        BadLog log = BadLog.init(args[0]);
        for (int i = 0; i < Signals.QUERIED; i++) {
            BadLog.createTopic(names[i], "V", supplier);
        }
        for (int i = Signals.QUERIED; i < names.length; i++) {
            BadLog.createTopicSubscriber(names[i], "V", DataInferMode.DEFAULT);
        }
        BadLog.createValue("Match Number", "8");
        log.finishInitialization();
        for (int i = Signals.QUERIED; i < names.length; i++) {
            BadLog.publish(names[i], i);
        }
        log.updateTopics();
        log.log();
        System.out.println((System.nanoTime() - began) / 1000);
    }
}

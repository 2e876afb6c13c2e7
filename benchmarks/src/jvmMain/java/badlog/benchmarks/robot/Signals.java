package badlog.benchmarks.robot;

/** The numbers of a robot: 50 that change in each loop. They come from a table, so that computing them takes no time. */
final class Signals {
    static final int QUERIED = 40;
    static final int PUBLISHED = 10;

    private static final int TABLE = 4096;

    private final double[] table = new double[TABLE];
    private int loop;

    Signals() {
        for (int i = 0; i < TABLE; i++) {
            table[i] = Math.sin(i * 0.37) * Math.pow(10, i % 7 - 2);
        }
    }

    void next() {
        loop++;
    }

    double signal(int number) {
        return table[(loop + number * 61) & (TABLE - 1)];
    }
}

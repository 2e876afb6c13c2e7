package badlog.benchmarks;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.function.IntFunction;
import org.openqa.selenium.chrome.ChromeDriver;

/** Measures the script of zooms into a graph of y over x, of a million samples, on a page. All of it is redrawn within the event. */
final class PathOnPage {
    private static final int SAMPLES = 1_000_000;
    private static final int ZOOMS = 30;

    private PathOnPage() {
    }

    /**
     * Returns the table's lines for pages that {@code program} makes in the folder {@code work}. The pages show a robot's path, and voltage
     * over current.
     */
    static List<String> measure(String program, Path work) throws Exception {
        Path path = work.resolve("path.bag");
        write(path, "Drive/Pose X", "Drive/Pose Y", "m", "m", i -> new double[] {
            8.27 + 6.6 * Math.sin(2 * Math.PI * i / 1500) * Math.cos(i / 90_000.0),
            4.03 + 3.2 * Math.cos(2 * Math.PI * i / 1100)
        });
        Path dots = work.resolve("dots.bag");
        Random random = new Random(1);
        write(dots, "PDP/Current", "PDP/Voltage", "A", "V", i -> {
            double amperes = 180 * Math.pow(Math.sin(2 * Math.PI * i / 700), 2) + 20 * random.nextDouble();
            return new double[] {amperes, 12.7 - 0.018 * amperes - i * 8e-7 + 0.05 * random.nextGaussian()};
        });
        return List.of(
            measure(program, path, "Drive/Pose+X,Drive/Pose+Y"),
            measure(program, dots, "PDP/Current,PDP/Voltage"));
    }

    private static String measure(String program, Path bag, String lines) throws Exception {
        Path page = bag.resolveSibling(bag.getFileName() + ".html");
        int exit = new ProcessBuilder(program, bag.toString(), page.toString()).inheritIO().start().waitFor();
        if (exit != 0) {
            throw new IllegalStateException("badlog-html exited with " + exit + " for " + bag);
        }
        ChromeDriver browser = PageBenchmark.start();
        try {
            PageBenchmark.open(browser, page.toUri() + "#board=" + lines + ",t=Path,p=");
            List<Double> times = new ArrayList<>();
            for (int zoom = 0; zoom < ZOOMS; zoom++) {
                times.add(((Number) browser.executeScript(
                    "const over = [...document.querySelectorAll('.xy')].pop();"
                        + "const box = over.getBoundingClientRect();"
                        + "const wheel = new WheelEvent('wheel', {deltaY: arguments[0], ctrlKey: true, cancelable: true,"
                        + " clientX: box.x + box.width / 2, clientY: box.y + box.height / 2});"
                        + "const start = performance.now(); over.dispatchEvent(wheel); return performance.now() - start",
                    zoom % 10 < 5 ? -60 : 60)).doubleValue());
                Thread.sleep(100);
            }
            Collections.sort(times);
            return String.format(Locale.ROOT, "| %s | %d | %.1f ms | %.1f ms |", bag.getFileName(), SAMPLES, times.get(ZOOMS / 2), times.get(ZOOMS - 1));
        } finally {
            browser.quit();
        }
    }

    private static void write(Path bag, String x, String y, String xUnit, String yUnit, IntFunction<double[]> sample) throws IOException {
        try (BufferedWriter out = Files.newBufferedWriter(bag)) {
            out.write("{\"topics\":[{\"name\":\"Time\",\"unit\":\"s\",\"attrs\":[\"xaxis\"]},"
                + "{\"name\":\"" + x + "\",\"unit\":\"" + xUnit + "\",\"attrs\":[]},"
                + "{\"name\":\"" + y + "\",\"unit\":\"" + yUnit + "\",\"attrs\":[]}],\"values\":[]}\nTime," + x + "," + y + "\n");
            for (int i = 0; i < SAMPLES; i++) {
                double[] values = sample.apply(i);
                out.write(String.format(Locale.ROOT, "%.2f,%.3f,%.3f%n", i * 0.02, values[0], values[1]));
            }
        }
    }
}

package badlog.benchmarks;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import org.openqa.selenium.chrome.ChromeDriver;

/** Measures the script of zooms into a robot's path of a million poses on a page: the path is redrawn within the event. */
final class PathOnPage {
    private static final int POSES = 1_000_000;
    private static final int ZOOMS = 30;

    private PathOnPage() {
    }

    /** Returns the table's line for a page that {@code program} makes in the folder {@code work}. */
    static String measure(String program, Path work) throws Exception {
        Path bag = work.resolve("path.bag");
        Path page = work.resolve("path.bag.html");
        write(bag);
        int exit = new ProcessBuilder(program, bag.toString(), page.toString()).inheritIO().start().waitFor();
        if (exit != 0) {
            throw new IllegalStateException("badlog-html exited with " + exit + " for " + bag);
        }
        ChromeDriver browser = PageBenchmark.start();
        try {
            PageBenchmark.open(browser, page.toUri() + "#board=Drive/Pose+X,Drive/Pose+Y,t=Path,p=");
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
            return String.format(Locale.ROOT, "| path.bag | %d | %.1f ms | %.1f ms |", POSES, times.get(ZOOMS / 2), times.get(ZOOMS - 1));
        } finally {
            browser.quit();
        }
    }

    private static void write(Path bag) throws IOException {
        try (BufferedWriter out = Files.newBufferedWriter(bag)) {
            out.write("{\"topics\":[{\"name\":\"Time\",\"unit\":\"s\",\"attrs\":[\"xaxis\"]},"
                + "{\"name\":\"Drive/Pose X\",\"unit\":\"m\",\"attrs\":[]},"
                + "{\"name\":\"Drive/Pose Y\",\"unit\":\"m\",\"attrs\":[]}],\"values\":[]}\nTime,Drive/Pose X,Drive/Pose Y\n");
            for (int i = 0; i < POSES; i++) {
                double x = 8.27 + 6.6 * Math.sin(2 * Math.PI * i / 1500) * Math.cos(i / 90_000.0);
                double y = 4.03 + 3.2 * Math.cos(2 * Math.PI * i / 1100);
                out.write(String.format(Locale.ROOT, "%.2f,%.3f,%.3f%n", i * 0.02, x, y));
            }
        }
    }
}

package badlog.benchmarks;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.openqa.selenium.By;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.chrome.ChromeDriver;
import org.openqa.selenium.chrome.ChromeDriverService;
import org.openqa.selenium.chrome.ChromeOptions;
import org.openqa.selenium.interactions.Actions;

/**
 * Measures exported pages in headless Chromium: the time from opening to the first graphs, the memory that JavaScript holds
 * then, and how long a zoom by mouse takes to reach all graphs on screen.
 *
 * <p>Arguments: the program that exports, the folder to work in, the file for the results, and a folder of bags or nothing.
 * Needs {@code chromium} and {@code chromedriver} on the PATH.
 */
public final class PageBenchmark {
    private static final int ZOOMS = 6;

    private PageBenchmark() {
    }

    public static void main(String[] args) throws Exception {
        Path work = Path.of(args[1]);
        List<String> lines = new ArrayList<>();
        lines.add("| page of | size | first graphs | JavaScript memory | graphs on screen | zoom, median | zoom, slowest |");
        lines.add("|---|---|---|---|---|---|---|");
        for (Path bag : MeasuredBags.find(args.length > 3 ? args[3] : "", work.resolve("bags"))) {
            Path page = work.resolve(bag.getFileName() + ".html");
            int exit = new ProcessBuilder(args[0], bag.toString(), page.toString()).inheritIO().start().waitFor();
            if (exit != 0) {
                throw new IllegalStateException("badlog-html exited with " + exit + " for " + bag);
            }
            lines.add(measure(bag, page));
        }
        Files.write(Path.of(args[2]), lines);
        lines.forEach(System.out::println);
    }

    private static String measure(Path bag, Path page) throws Exception {
        ChromeDriver browser = start();
        try {
            double opened = Double.MAX_VALUE;
            int rounds = MeasuredBags.size(page) > 100_000_000 ? 1 : 3;
            for (int round = 0; round < rounds; round++) {
                opened = Math.min(opened, open(browser, page));
            }
            double memory = memory(browser);
            List<Double> zooms = zooms(browser);
            return String.format(Locale.ROOT, "| %s | %.1f MB | %.2f s | %.0f MB | %d | %.1f ms | %.1f ms |",
                bag.getFileName(), MeasuredBags.size(page) / 1e6, opened, memory, graphsOnScreen(browser),
                zooms.get(zooms.size() / 2), zooms.get(zooms.size() - 1));
        } finally {
            browser.quit();
        }
    }

    private static ChromeDriver start() {
        ChromeOptions options = new ChromeOptions();
        options.setBinary(onPath("chromium"));
        options.addArguments("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
            "--disable-background-networking", "--disable-component-update", "--disable-sync");
        // Named, because Selenium would otherwise ask the network for one.
        ChromeDriverService service = new ChromeDriverService.Builder()
            .usingDriverExecutable(onPath("chromedriver"))
            .build();
        ChromeDriver browser = new ChromeDriver(service, options);
        browser.manage().window().setSize(new Dimension(1600, 1000));
        browser.manage().timeouts().pageLoadTimeout(Duration.ofMinutes(2)).scriptTimeout(Duration.ofMinutes(2));
        return browser;
    }

    private static File onPath(String program) {
        for (String folder : System.getenv("PATH").split(File.pathSeparator)) {
            File file = new File(folder, program);
            if (file.canExecute()) {
                return file;
            }
        }
        throw new IllegalStateException("The page is measured with " + program + ", which is not on the PATH.");
    }

    /** Seconds from the start of loading to the first graphs. */
    private static double open(ChromeDriver browser, Path page) throws InterruptedException {
        browser.get("about:blank");
        browser.get(page.toUri().toString());
        for (int tries = 0; tries < 6000; tries++) {
            Object mark = browser.executeScript(
                "const m = performance.getEntriesByName('badlog-first-graphs')[0]; return m ? m.startTime : null");
            if (mark != null) {
                return ((Number) mark).doubleValue() / 1000;
            }
            Thread.sleep(10);
        }
        throw new IllegalStateException("No graphs appeared within a minute in " + page);
    }

    /** Megabytes of live objects and of the arrays outside the heap, after a collection. */
    private static double memory(ChromeDriver browser) {
        browser.executeCdpCommand("HeapProfiler.enable", Map.of());
        browser.executeCdpCommand("HeapProfiler.collectGarbage", Map.of());
        Map<String, Object> usage = browser.executeCdpCommand("Runtime.getHeapUsage", Map.of());
        double bytes = ((Number) usage.get("usedSize")).doubleValue();
        for (String more : List.of("backingStorageSize", "embedderHeapUsedSize")) {
            if (usage.get(more) != null) {
                bytes += ((Number) usage.get(more)).doubleValue();
            }
        }
        return bytes / 1e6;
    }

    /** Milliseconds that each of some zooms by mouse took, from the first redraw's begin to the last one's end, sorted. */
    private static List<Double> zooms(ChromeDriver browser) throws InterruptedException {
        awaitRules(browser);
        browser.executeScript("arguments[0].scrollIntoView({ block: 'center' })", graph(browser));
        Thread.sleep(1000);
        List<Double> times = new ArrayList<>();
        for (int zoom = 0; zoom < ZOOMS; zoom++) {
            browser.executeScript("performance.clearMeasures()");
            // Looked up anew, for a graph that left the screen meanwhile is drawn on another element.
            WebElement frame = graph(browser).findElement(By.cssSelector(".u-over"));
            int width = frame.getSize().getWidth();
            new Actions(browser).moveToElement(frame, -width / 4, 0).clickAndHold()
                .moveByOffset(width / 4, 0).moveByOffset(width / 4, 0).release().perform();
            Thread.sleep(500);
            Object duration = browser.executeScript(
                "return Math.max(0, ...performance.getEntriesByName('badlog-zoom').map(m => m.duration))");
            times.add(((Number) duration).doubleValue());
        }
        return times.stream().sorted().toList();
    }

    /** Away from the header and the values, where the screen is full of graphs. */
    private static WebElement graph(ChromeDriver browser) {
        return browser.findElements(By.cssSelector("section.graph")).get(3);
    }

    /** The rules run beside what is measured, and move the graphs when their findings are listed. */
    private static void awaitRules(ChromeDriver browser) throws InterruptedException {
        for (int tries = 0; tries < 6000; tries++) {
            if (Boolean.TRUE.equals(browser.executeScript("return 'rules' in document.documentElement.dataset"))) {
                return;
            }
            Thread.sleep(10);
        }
        throw new IllegalStateException("The rules were not done within a minute");
    }

    private static int graphsOnScreen(ChromeDriver browser) {
        return ((Number) browser.executeScript(
            "return [...document.querySelectorAll('section.graph canvas')].filter(c => { const r ="
                + " c.getBoundingClientRect(); return r.bottom > 0 && r.top < innerHeight }).length")).intValue();
    }
}

package badlog.benchmarks;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.openqa.selenium.By;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.chrome.ChromeDriver;
import org.openqa.selenium.chrome.ChromeDriverService;
import org.openqa.selenium.chrome.ChromeOptions;
import org.openqa.selenium.interactions.Actions;

/**
 * Measures exported pages in headless Chromium. Times: from opening to the first graphs, and until a zoom by mouse has reached all graphs
 * on screen. Memory: of JavaScript at the first graphs. The zoom is also measured with ten graphs on the board, and with the processor
 * slowed down six times, to about a phone's speed. Of a list of logs, the longest tasks.
 *
 * <p>Arguments: the program that exports, the folder to work in, the file for the results, and a folder of bags or nothing. Needs {@code
 * chromium} and {@code chromedriver} on the PATH.
 */
public final class PageBenchmark {
    private static final int ZOOMS = 6;
    private static final int BOARD = 10;
    private static final int SLOWED = 6;
    private static final String BOARD_GRAPHS = "#board section.graph";

    private PageBenchmark() {
    }

    public static void main(String[] args) throws Exception {
        Path work = Path.of(args[1]);
        List<String> lines = new ArrayList<>();
        lines.add("| page of | size | first graphs | JavaScript memory | graphs on screen | zoom, median | zoom, slowest |");
        lines.add("|---|---|---|---|---|---|---|");
        List<String> boards = new ArrayList<>();
        boards.add("| page of, with a board | graphs on screen | script of a zoom, median | zoom, median | first graphs, slowed | script of a zoom, slowed |");
        boards.add("|---|---|---|---|---|---|");
        for (Path bag : MeasuredBags.find(args.length > 3 ? args[3] : "", work.resolve("bags"))) {
            Path page = work.resolve(bag.getFileName() + ".html");
            export(args[0], bag.toString(), page.toString());
            lines.add(measure(bag, page));
            boards.add(measureBoard(bag, page));
        }
        lines.add("");
        lines.addAll(boards);
        lines.add("");
        lines.add("| page of, with y over x | samples | script of a zoom into it, median | slowest |");
        lines.add("|---|---|---|---|");
        lines.addAll(PathOnPage.measure(args[0], work));
        export(args[0], "--empty", "--out", work + "/");
        lines.add("");
        lines.addAll(ListOnPage.measure(work.resolve("badlog.html"), work));
        lines.add("");
        lines.add("`badlog.html`, which opens any log, has " + Files.size(work.resolve("badlog.html")) + " bytes.");
        Files.write(Path.of(args[2]), lines);
        lines.forEach(System.out::println);
    }

    private static void export(String... command) throws Exception {
        int exit = new ProcessBuilder(command).inheritIO().start().waitFor();
        if (exit != 0) {
            throw new IllegalStateException(String.join(" ", command) + " exited with " + exit);
        }
    }

    private static String measure(Path bag, Path page) throws Exception {
        ChromeDriver browser = start();
        try {
            double opened = quickest(browser, page, page.toUri().toString());
            double memory = memory(browser);
            List<Double> zooms = zooms(browser, "badlog-zoom", "section.graph", 3);
            return String.format(Locale.ROOT, "| %s | %.1f MB | %.2f s | %.0f MB | %d | %.1f ms | %.1f ms |",
                bag.getFileName(), MeasuredBags.size(page) / 1e6, opened, memory, graphsOnScreen(browser),
                zooms.get(zooms.size() / 2), zooms.get(zooms.size() - 1));
        } finally {
            browser.quit();
        }
    }

    /**
     * Returns the table's line for a page with a board of {@link #BOARD} short graphs. The address contains the board, and the screen is
     * high enough to draw all of them.
     */
    private static String measureBoard(Path bag, Path page) throws Exception {
        ChromeDriver browser = start();
        try {
            browser.manage().window().setSize(new Dimension(1600, 2400));
            String address = page.toUri().toString();
            open(browser, address);
            List<String> names = names(browser);
            address += names.stream().map(name -> escaped(name) + ",h=60").collect(Collectors.joining(";", "#board=", ""));
            open(browser, address);
            List<Double> script = zooms(browser, "badlog-zoom-script", BOARD_GRAPHS, 1);
            List<Double> zooms = zooms(browser, "badlog-zoom", BOARD_GRAPHS, 1);
            int shown = graphsOnScreen(browser);
            browser.executeCdpCommand("Emulation.setCPUThrottlingRate", Map.of("rate", SLOWED));
            double opened = quickest(browser, page, address);
            List<Double> slowed = zooms(browser, "badlog-zoom-script", BOARD_GRAPHS, 1);
            return String.format(Locale.ROOT, "| %s | %d | %.1f ms | %.1f ms | %.2f s | %.1f ms |", bag.getFileName(), shown,
                script.get(script.size() / 2), zooms.get(zooms.size() / 2), opened, slowed.get(slowed.size() / 2));
        } finally {
            browser.quit();
        }
    }

    /** The names of the first numeric topics that the page draws. */
    private static List<String> names(ChromeDriver browser) {
        Object names = browser.executeScript("return [...new Set([...document.querySelectorAll('section.graph[data-kind=lines]')]"
            + ".map(graph => graph.dataset.name))].slice(0, arguments[0])", BOARD);
        return ((List<?>) names).stream().map(String::valueOf).toList();
    }

    /** Returns a name in the form used in the text of a board. */
    private static String escaped(String name) {
        StringBuilder text = new StringBuilder();
        name.chars().forEach(c -> {
            if (c == ' ') {
                text.append('+');
            } else if (c < 128 && (Character.isLetterOrDigit(c) || "-_./".indexOf(c) >= 0)) {
                text.append((char) c);
            } else {
                text.append(String.format(Locale.ROOT, "~%04x", c));
            }
        });
        return text.toString();
    }

    static ChromeDriver start() {
        ChromeOptions options = new ChromeOptions();
        options.setBinary(onPath("chromium"));
        options.addArguments("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
            "--disable-background-networking", "--disable-component-update", "--disable-sync");
        // Set explicitly, because Selenium would otherwise download a driver.
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

    /** Returns the shortest of three times of {@link #open}, or a single time if the page is huge. */
    private static double quickest(ChromeDriver browser, Path page, String address) throws Exception {
        double opened = Double.MAX_VALUE;
        int rounds = MeasuredBags.size(page) > 100_000_000 ? 1 : 3;
        for (int round = 0; round < rounds; round++) {
            opened = Math.min(opened, open(browser, address));
        }
        return opened;
    }

    /** Returns the time from the start of loading to the first graphs, in s. */
    static double open(ChromeDriver browser, String page) throws InterruptedException {
        browser.get("about:blank");
        browser.get(page);
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

    /** Returns the size of live objects and of arrays outside the heap after a collection, in MB. */
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

    /**
     * Returns the page's own {@code measure} of some zooms by mouse in one of {@code graphs}, in ms, sorted. {@code badlog-zoom} lasts from
     * the change of the range until all graphs on screen are drawn, {@code badlog-zoom-script} is the script's share of that.
     */
    private static List<Double> zooms(ChromeDriver browser, String measure, String graphs, int place) throws InterruptedException {
        awaitRules(browser);
        browser.executeScript("arguments[0].scrollIntoView({ block: 'center' })", graph(browser, graphs, place));
        Thread.sleep(1000);
        List<Double> times = new ArrayList<>();
        for (int zoom = 0; zoom < ZOOMS; zoom++) {
            browser.executeScript("performance.clearMeasures()");
            // Looked up each time, because a graph that left the screen meanwhile is drawn on another element.
            WebElement frame = graph(browser, graphs, place).findElement(By.cssSelector(".plot-frame"));
            int width = frame.getSize().getWidth();
            new Actions(browser).moveToElement(frame, -width / 4, 0).clickAndHold()
                .moveByOffset(width / 4, 0).moveByOffset(width / 4, 0).release().perform();
            Thread.sleep(500);
            Object duration = browser.executeScript(
                "return Math.max(0, ...performance.getEntriesByName(arguments[0]).map(m => m.duration))", measure);
            times.add(((Number) duration).doubleValue());
        }
        return times.stream().sorted().toList();
    }

    /** Returns the graph at {@code place}. It is not the first one, because header and values take part of the screen around it. */
    private static WebElement graph(ChromeDriver browser, String graphs, int place) {
        return browser.findElements(By.cssSelector(graphs)).get(place);
    }

    /** Waits until the rules have run: they would slow down the measured zooms, and listing their findings moves the graphs. */
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

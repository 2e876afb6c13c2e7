package badlog.benchmarks;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.openqa.selenium.By;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.Keys;
import org.openqa.selenium.chrome.ChromeDriver;

/**
 * Measures the page's longest task while a person searches, sorts and scrolls a list of 1,000 logs, and while they are read. The browser
 * reports only tasks over 50 ms.
 */
final class ListOnPage {
    private static final int LOGS = 1000;
    private static final int ROWS = 500;
    private static final String TASKS = "window.tasks = []; new PerformanceObserver(list => tasks.push(...list.getEntries()))"
        + ".observe({ type: 'longtask' })";

    private ListOnPage() {
    }

    /** Returns the table's lines for the page {@code badlog.html} and logs in the folder {@code work}. */
    static List<String> measure(Path page, Path work) throws Exception {
        Path folder = work.resolve("list");
        if (Files.notExists(folder)) {
            write(folder);
        }
        List<String> lines = new ArrayList<>(List.of("| in a list of 1,000 logs | longest task |", "|---|---|"));
        ChromeDriver browser = PageBenchmark.start();
        try {
            browser.manage().window().setSize(new Dimension(1366, 768));
            browser.get(page.toUri().toString());
            Thread.sleep(1000);
            browser.executeScript(TASKS);
            browser.findElements(By.cssSelector("input[type=file]")).get(1).sendKeys(folder.toString());
            awaitAll(browser);
            lines.add(longest(browser, "reading"));
            for (char letter : "browned".toCharArray()) {
                browser.findElement(By.id("search")).sendKeys(String.valueOf(letter));
                Thread.sleep(300);
            }
            lines.add(longest(browser, "typing a word"));
            for (int i = 0; i < "browned".length(); i++) {
                browser.findElement(By.id("search")).sendKeys(Keys.BACK_SPACE);
                Thread.sleep(300);
            }
            lines.add(longest(browser, "erasing it"));
            for (String column : List.of("MATCH", "FINDINGS", "BATTERY", "DATE")) {
                browser.findElement(By.cssSelector(".log-table th." + column + " button")).click();
                Thread.sleep(300);
            }
            lines.add(longest(browser, "sorting by four columns"));
            for (int i = 0; i < 200; i++) {
                browser.executeScript("scrollBy(0, 300)");
                Thread.sleep(20);
            }
            lines.add(longest(browser, "scrolling through it"));
        } finally {
            browser.quit();
        }
        return lines;
    }

    private static void awaitAll(ChromeDriver browser) throws InterruptedException {
        for (int tries = 0; tries < 3000; tries++) {
            Object status = browser.executeScript("return document.querySelector('.log-tools [role=status]')?.textContent ?? 'read'");
            if (!status.toString().contains("read")) {
                Thread.sleep(1000);
                return;
            }
            Thread.sleep(100);
        }
        throw new IllegalStateException("The logs were not read within five minutes");
    }

    /** Returns the table's line for the longest task since the last call. */
    private static String longest(ChromeDriver browser, String what) {
        long longest = Math.round(((Number) browser.executeScript(
            "return Math.max(0, ...tasks.splice(0).map(task => task.duration))")).doubleValue());
        return String.format(Locale.ROOT, "| %s | %s |", what, longest == 0 ? "under 50 ms" : longest + " ms");
    }

    /** Writes the logs of the matches of 25 days; every fifth has a brownout. */
    private static void write(Path folder) throws Exception {
        Files.createDirectories(folder);
        for (int log = 0; log < LOGS; log++) {
            int day = 1 + log / 40;
            int number = 1 + log % 40;
            StringBuilder bag = new StringBuilder(String.format(Locale.ROOT, "{\"topics\":[{\"name\":\"Time\",\"unit\":\"s\",\"attrs\":[\"xaxis\"]},"
                + "{\"name\":\"System/Enabled\",\"unit\":\"ul\",\"attrs\":[]},{\"name\":\"System/Browned Out\",\"unit\":\"ul\",\"attrs\":[]},"
                + "{\"name\":\"System/Battery Voltage\",\"unit\":\"V\",\"attrs\":[]}],\"values\":["
                + "{\"name\":\"Start Time\",\"value\":\"2024-03-%02dT%02d:%02d:00\"},{\"name\":\"Event Name\",\"value\":\"Mill Creek Regional\"},"
                + "{\"name\":\"Match Type\",\"value\":\"Qualification\"},{\"name\":\"Match Number\",\"value\":\"%d\"}]}\n"
                + "Time,System/Enabled,System/Browned Out,System/Battery Voltage\n", day, 9 + number / 6, number % 6 * 10, number));
            for (int row = 0; row < ROWS; row++) {
                boolean isLow = log % 5 == 0 && row > 300 && row < 310;
                double volts = isLow ? 6.4 : 12.5 - 3 * Math.abs(Math.sin(row * 0.05 + log));
                bag.append(String.format(Locale.ROOT, "%.1f,%b,%b,%.2f\n", row * 0.3, row > 20, isLow, volts));
            }
            Files.writeString(folder.resolve("log-" + log + ".bag"), bag);
        }
    }
}

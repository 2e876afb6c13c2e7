package badlog.robots;

import badlog.web.LogServer;
import badlog.web.LogServerOptions;
import java.io.File;
import java.io.IOException;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** Robots that show their logs, as in docs/web.md; and one whose program ends meanwhile: when it is sent a byte, or after so many ms. */
public final class ServingRobot {
    private ServingRobot() {
    }

    static void usual() {
        LogServer.start(5806);
    }

    static void withOptions() {
        LogServerOptions options = new LogServerOptions();
        options.setFolders(List.of(new File("/media/sda1/logs")));
        options.setAlwaysOpen(true);
        LogServer.start(5806, options);
    }

    public static void main(String[] args) throws InterruptedException, IOException {
        LogServer.start(Integer.parseInt(args[0]));
        long begin = System.nanoTime();
        long longest = TimeUnit.MILLISECONDS.toNanos(Long.parseLong(args[1]));
        while (System.in.available() == 0 && System.nanoTime() - begin < longest) {
            Thread.sleep(5);
        }
    }
}

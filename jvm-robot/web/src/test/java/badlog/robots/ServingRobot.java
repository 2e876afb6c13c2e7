package badlog.robots;

import badlog.web.LogServer;
import badlog.web.LogServerOptions;
import java.io.File;
import java.util.List;

/** Robots that show their logs, as in docs/web.md. One of them ends once it serves, or has reported why it does not. */
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

    public static void main(String[] args) throws InterruptedException {
        LogServer.start(Integer.parseInt(args[0]));
        // The thread that opens the port.
        for (Thread thread : Thread.getAllStackTraces().keySet()) {
            if (thread.getName().equals("badlog web")) {
                thread.join();
            }
        }
    }
}

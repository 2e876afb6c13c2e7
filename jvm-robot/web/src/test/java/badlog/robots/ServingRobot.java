package badlog.robots;

import badlog.web.LogServer;
import badlog.web.LogServerOptions;

/** A robot whose program ends while it serves its logs; without an argument it serves where teams' programs do. */
public final class ServingRobot {
    private ServingRobot() {
    }

    public static void main(String[] args) throws InterruptedException {
        if (args.length == 0) {
            LogServer.start(5806);
            return;
        }
        LogServerOptions options = new LogServerOptions();
        options.setAlwaysOpen(true);
        LogServer.start(Integer.parseInt(args[0]), options);
        Thread.sleep(Long.parseLong(args[1]));
    }
}

package badlog.benchmarks.robot;

import java.io.InputStream;
import java.net.URI;

/** Downloads a log twice at the same time, repeatedly, until the program is ended. Arguments: the address of the log. */
final class Downloads {
    private Downloads() {
    }

    public static void main(String[] args) {
        for (int i = 0; i < 2; i++) {
            new Thread(() -> download(args[0])).start();
        }
    }

    private static void download(String address) {
        byte[] buffer = new byte[1 << 16];
        boolean hasBegun = false;
        while (true) {
            try (InputStream in = URI.create(address).toURL().openStream()) {
                while (in.read(buffer) >= 0) {
                    if (!hasBegun) {
                        System.out.println("begun");
                        hasBegun = true;
                    }
                }
            } catch (java.io.IOException failure) {
                System.out.println("failed: " + failure);
                return;
            }
        }
    }
}

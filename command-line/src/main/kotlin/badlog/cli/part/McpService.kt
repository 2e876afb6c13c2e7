package badlog.cli.part

import badlog.cli.command.ExitCode
import java.io.InputStream
import java.io.OutputStream
import java.nio.file.Path

/** What `badlog mcp` calls: answers the questions of an assistant about logs, in the Model Context Protocol. */
public interface McpService {
    /**
     * Answers what comes from [input], until its end.
     *
     * @param folder the only folder whose logs may be asked about.
     * @param cache where answers are kept that take long, as other commands keep them.
     * @param output gets the answers, and nothing but the protocol.
     * @param warn gets, as sentences, what the person who started this should know.
     */
    public fun serve(folder: Path, cache: Path, input: InputStream, output: OutputStream, warn: (String) -> Unit): ExitCode
}

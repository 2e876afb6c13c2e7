package badlog.cli.plugin

import badlog.cli.command.ExitCode
import java.io.InputStream
import java.io.OutputStream
import java.nio.file.Path

/** Answers the questions of an assistant about logs in the Model Context Protocol, for `badlog mcp`. */
public interface McpService {
    /**
     * Answers requests from [input], until its end.
     *
     * @param folder the only folder with accessible logs.
     * @param cache the folder for cached results, shared with other commands.
     * @param output receives the answers, and nothing but the protocol.
     * @param warn receives sentences for the person who started this.
     */
    public fun serve(folder: Path, cache: Path, input: InputStream, output: OutputStream, warn: (String) -> Unit): ExitCode
}

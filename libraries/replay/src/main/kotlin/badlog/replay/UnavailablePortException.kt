package badlog.replay

import java.io.IOException
import java.net.BindException
import java.net.InetSocketAddress

/** The port of a replay cannot be opened. The message is one sentence that says why and what to do. */
public class UnavailablePortException internal constructor(address: InetSocketAddress, cause: Exception) :
    IOException(
        if (cause is BindException && "in use" in cause.message.orEmpty()) {
            "Port ${address.port} is taken, by a robot simulation or another replay perhaps: " +
                "end that program, or choose another port."
        } else {
            "Port ${address.port} of ${address.address.hostAddress} cannot be opened (${cause.message}): choose another."
        },
        cause,
    )

package badlog.replay

/** What a [SocketServer] tells of its connections; of one connection nothing at the same time. */
internal interface Listener {
    fun opened(connection: Connection)

    fun received(connection: Connection, text: String)

    fun closed(connection: Connection)
}

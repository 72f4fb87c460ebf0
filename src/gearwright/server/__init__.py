"""The designer page's server: HTTP and WebSocket in, jobs for worker processes, what they answer out."""

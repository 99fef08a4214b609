"""What travels between browser and server. Imports only pydantic."""

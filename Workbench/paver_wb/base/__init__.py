"""What documents, formats and processes share; knows neither."""
